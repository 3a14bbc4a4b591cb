#include "demos/frame_options.h"

#include "demos/errors.h"
#include "demos/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pushfactor::demos {

namespace {

constexpr int max_side = 4096;

bool set_size(FrameChoices& choices, std::string_view text) {
    const auto x = text.find('x');
    if (x == std::string_view::npos) return false;
    const auto width = parse_integer(text.substr(0, x));
    const auto height = parse_integer(text.substr(x + 1));
    if (!width || !height || std::min(*width, *height) < 16 || std::max(*width, *height) > max_side) return false;
    choices.width = *width;
    choices.height = *height;
    return true;
}

bool set_fps(FrameChoices& choices, std::string_view text) {
    const auto fps = parse_rational(text);
    if (!fps || fps->numerator <= 0 || fps->value() > 1e6) return false;
    choices.fps = fps;
    return true;
}

bool set_at(FrameChoices& choices, std::string_view text) {
    std::vector<Rational> times;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto time = parse_rational(text.substr(begin, end - begin));
        if (!time || time->numerator < 0) return false;
        times.push_back(*time);
        begin = end + 1;
    }
    choices.at = times;
    return true;
}

std::string get_at(const FrameChoices& choices) {
    std::string text;
    for (const Rational& time : choices.at) text += (text.empty() ? "" : ",") + to_text(time);
    return text;
}

constexpr std::array options{
    FrameOption{"size", "WxH", "size of a frame in pixels [1280x720]", "WxH with each side from 16 to 4096 pixels",
                set_size, [](const FrameChoices& c) { return fmt::format("{}x{}", c.width, c.height); }},
    FrameOption{
        "fps", "N", "frames (or trajectory lines) a simulated second; each must fall on a step [60 for frames]",
        "a number above 0", set_fps, [](const FrameChoices& c) { return c.fps ? to_text(*c.fps) : std::string(); }},
    FrameOption{"at", "T,T,...", "stills at these times in s instead of a sequence",
                "times in s from 0, separated by commas, like 0,0.5,10", set_at, get_at},
};

// The whole rates nearest to `fps` that divide the rate of the steps.
std::string rates_that_fit(const Rational& fps, const Rational& dt) {
    const Rational steps_a_second = Rational{1, 1} / dt;
    std::vector<Rational> rates;
    for (std::int64_t k = 1; k <= 10000; ++k) {
        const Rational rate = steps_a_second / Rational{k, 1};
        if (rate.is_whole() || k == 1) rates.push_back(rate);
    }
    std::stable_sort(rates.begin(), rates.end(), [&](const Rational& a, const Rational& b) {
        return std::abs(a.value() - fps.value()) < std::abs(b.value() - fps.value());
    });
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(4, rates.size()); ++i) {
        text += (text.empty() ? "" : ", ") + to_text(rates[i]);
    }
    return text;
}

}  // namespace

std::span<const FrameOption> frame_options() {
    return options;
}

long steps_a_frame(const Rational& fps, const Rational& dt) {
    const Rational steps = Rational{1, 1} / (fps * dt);
    if (!steps.is_whole()) {
        throw UsageError(
            fmt::format("--fps {}: a frame must be a whole number of steps of {} s; rates that fit are {}",
                        to_text(fps), to_text(dt), rates_that_fit(fps, dt)));
    }
    return static_cast<long>(steps.numerator);
}

std::vector<Frame> plan_frames(const FrameChoices& choices, const Rational& dt, long steps) {
    std::vector<Frame> frames;
    if (choices.at.empty()) {
        const long every = steps_a_frame(choices.fps.value_or(Rational{60, 1}), dt);
        for (long n = 0; n * every <= steps; ++n) frames.push_back({n * every, fmt::format("frame_{:06}.png", n)});
        return frames;
    }
    for (const Rational& time : choices.at) {
        const Rational step = time / dt;
        if (!step.is_whole()) {
            const long below = static_cast<long>(std::floor(step.value()));
            throw UsageError(fmt::format(
                "--at {}: must be a whole number of steps of {} s; the nearest are {} and {}", to_text(time),
                to_text(dt), to_text(dt * Rational{below, 1}), to_text(dt * Rational{below + 1, 1})));
        }
        if (step.numerator > steps) {
            throw UsageError(fmt::format("--at {}: must be within the {} s of the run", to_text(time),
                                         to_text(dt * Rational{steps, 1})));
        }
        std::string name = to_text(time);
        std::replace(name.begin(), name.end(), '/', '_');
        frames.push_back({static_cast<long>(step.numerator), "at_" + name + "s.png"});
    }
    std::stable_sort(frames.begin(), frames.end(), [](const Frame& a, const Frame& b) { return a.step < b.step; });
    const auto same = [](const Frame& a, const Frame& b) { return a.step == b.step; };
    frames.erase(std::unique(frames.begin(), frames.end(), same), frames.end());
    return frames;
}

}  // namespace pushfactor::demos
