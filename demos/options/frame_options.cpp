#include "demos/options/frame_options.h"

#include "demos/base/text/errors.h"
#include "demos/base/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pushfactor::demos {

namespace {

constexpr int min_side = 16, max_side = 4096;
constexpr int most_samples = 256;
constexpr std::size_t most_panels = 16;

bool set_size(FrameChoices& choices, std::string_view text) {
    const auto x = text.find('x');
    if (x == std::string_view::npos) return false;
    const auto width = parse_integer(text.substr(0, x), min_side, max_side);
    const auto height = parse_integer(text.substr(x + 1), min_side, max_side);
    if (!width || !height) return false;
    choices.width = *width;
    choices.height = *height;
    return true;
}

std::optional<Rational> parse_rate(std::string_view text) {
    const auto rate = parse_rational(text);
    return rate && rate->numerator > 0 && rate->value() <= 1e6 ? rate : std::nullopt;
}

std::optional<std::vector<Rational>> parse_times(std::string_view text) {
    std::vector<Rational> times;
    for (const std::string_view part : parts_of(text)) {
        const auto time = parse_rational(part);
        if (!time || time->numerator < 0 || time->value() > 1e6) return std::nullopt;
        times.push_back(*time);
    }
    return times;
}

std::optional<bool> parse_switch(std::string_view text) {
    return text == "on" || text == "off" ? std::optional(text == "on") : std::nullopt;
}

std::optional<std::string> parse_gl(std::string_view text) {
    return text == "osmesa" || text == "egl" ? std::optional(std::string(text)) : std::nullopt;
}

std::string text_of(const std::vector<Rational>& times) {
    std::string text;
    for (const Rational& time : times) text += (text.empty() ? "" : ",") + to_text(time);
    return text;
}

std::string text_of(const std::optional<Comparison>& compare) {
    return compare ? fmt::format("{}={}", compare->option, fmt::join(compare->values, ",")) : "";
}

// Sets a member to what `parse` makes of the text, if anything.
template <typename Parse, typename Member>
auto parsed(Parse parse, Member FrameChoices::*member) {
    return [=](FrameChoices& choices, std::string_view text) {
        const auto value = parse(text);
        if (value) choices.*member = *value;
        return value.has_value();
    };
}

const std::string rates = "a number above 0 and up to 1e6";
const std::string times = "times in s from 0 to 1e6, separated by commas, like 0,0.5,10";

const std::array frame_table{
    FrameOption{{"size", "WxH", "size of a frame in pixels, up to 4096 per side [1280x720]",
                 "WxH with each side from 16 to 4096 pixels", set_size,
                 [](const FrameChoices& c) { return fmt::format("{}x{}", c.width, c.height); }},
                of_pictures | of_models},
    FrameOption{{"fps", "N", "frames (or trajectory lines) per second; each must fall on a step [60 for frames]",
                 rates, parsed(parse_rate, &FrameChoices::fps),
                 [](const FrameChoices& c) { return c.fps ? to_text(*c.fps) : ""; }},
                of_film | of_shutter | of_trajectory | of_models | of_run},
    FrameOption{{"play-speed", "X",
                 "simulated seconds per second of video; slow motion (1/4) needs steps that are small enough [1]",
                 rates, parsed(parse_rate, &FrameChoices::play_speed),
                 [](const FrameChoices& c) {
                     return c.play_speed == Rational{1, 1} ? "" : to_text(c.play_speed);
                 }},
                of_film | of_shutter | of_models},
    FrameOption{{"at", "T,T,...", "stills at these times in s instead of a sequence; the run ends with the last",
                 times, parsed(parse_times, &FrameChoices::at),
                 [](const FrameChoices& c) { return text_of(c.at); }}},
    FrameOption{{"ghosts", "T,T,...",
                 "also draw the bodies as they were at these times in s, paler the older they are", times,
                 parsed(parse_times, &FrameChoices::ghosts),
                 [](const FrameChoices& c) { return text_of(c.ghosts); }}},
    FrameOption{
        {"samples", "N",
         "renderings averaged per picture: smoother edges and soft shadows; from 16 on ambient occlusion too [1]",
         fmt::format("a whole number from 1 to {}", most_samples),
         parsed([](std::string_view text) { return parse_integer(text, 1, most_samples); }, &FrameChoices::samples),
         [](const FrameChoices& c) { return c.samples == 1 ? "" : std::to_string(c.samples); }}},
    FrameOption{{"shutter", "X",
                 "motion blur: the share of a frame's time, 0 to 1, over which its --samples are spread; poses "
                 "between steps are interpolated, so take a small --dt for exact blur [0]",
                 "a number from 0 to 1",
                 parsed([](std::string_view text) { return parse_number(text, 0.0, 1.0); }, &FrameChoices::shutter),
                 [](const FrameChoices& c) { return c.shutter == 0.0 ? "" : to_text(c.shutter); }}},
    FrameOption{{"camera", "WHAT",
                 "scene (its own), FILE.json (keys of a scene file's camera), fit (close, with all motion in view, "
                 "turned where that fills the picture better), orbit:DEGREES_PER_SECOND, or a comma-separated list "
                 "of these [scene; fit for stills and comparisons]",
                 "scene, a camera file, fit or orbit:DEGREES_PER_SECOND (up to 1e4), or a comma-separated list of "
                 "these, each once, with scene or a file",
                 parsed(parse_camera, &FrameChoices::camera),
                 [](const FrameChoices& c) { return c.camera.text.empty() ? "scene" : c.camera.text; }},
                of_pictures | of_models | of_run},
    FrameOption{{"caption", "on|off", "time, scene and options in the picture [on]", "on or off",
                 parsed(parse_switch, &FrameChoices::caption),
                 [](const FrameChoices& c) { return c.caption ? "" : "off"; }}},
    FrameOption{
        {"overlay", "WHAT",
         "comma-separated list of contacts, forces, torques, push, velocities (points and arrows; forces:50 "
         "is 50 N per metre), islands (one colour each), rest (asleep, still or moving), no-contacts (lines "
         "between bodies that may not touch), thrust (the line of thrust), trails (paths of the last "
         "second; trails:0.5: half a second)",
         "a comma-separated list of contacts, forces, torques, push, velocities, islands, rest, "
         "no-contacts, thrust, trails, each once, with islands or rest; forces, torques, push and "
         "velocities may have a scale like forces:50, trails seconds, from 1e-12 to 1e12",
         parsed(parse_overlay, &FrameChoices::overlay), [](const FrameChoices& c) { return to_text(c.overlay); }},
        of_pictures | of_models | of_run},
    FrameOption{
        {"compare", "OPTION=V1,V2,...",
         "panels side by side that differ in an option, preset or parameter: push=none,persistent,single-frame",
         fmt::format("OPTION=V1,V2,... with 2 to {} different values", most_panels),
         parsed(parse_comparison, &FrameChoices::compare),
         [](const FrameChoices& c) { return text_of(c.compare); }},
        of_pictures | of_models},
    FrameOption{{"gl", "osmesa|egl",
                 "OpenGL back end; both give identical images [osmesa, or egl where that is not installed]",
                 "osmesa or egl", parsed(parse_gl, &FrameChoices::gl), [](const FrameChoices& c) { return c.gl; }}},
};

// Frame rates nearest to `fps` whose frames fall on steps at play speed `speed`; integers if possible.
std::string rates_that_fit(const Rational& fps, const Rational& dt, const Rational& speed) {
    const Rational steps_a_second = speed / dt;
    std::vector<Rational> fitting;
    for (std::int64_t k = 1; k <= 10000; ++k) {
        const Rational rate = steps_a_second / Rational{k, 1};
        if (rate.is_whole() || k == 1) fitting.push_back(rate);
    }
    std::stable_sort(fitting.begin(), fitting.end(), [&](const Rational& a, const Rational& b) {
        return std::abs(a.value() - fps.value()) < std::abs(b.value() - fps.value());
    });
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(4, fitting.size()); ++i) {
        text += (text.empty() ? "" : ", ") + to_text(fitting[i]);
    }
    return text;
}

// The step at a time that an option gives.
long step_of(std::string_view option, const Rational& time, const Rational& dt) {
    const Rational step = time / dt;
    if (!step.is_whole()) {
        const long below = static_cast<long>(std::floor(step.value()));
        throw UsageError("{} {}: must be a whole number of steps of {} s; the nearest are {} and {}", option,
                         to_text(time), to_text(dt), to_text(dt * Rational{below, 1}),
                         to_text(dt * Rational{below + 1, 1}));
    }
    return static_cast<long>(step.numerator);
}

}  // namespace

std::optional<Comparison> parse_comparison(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string_view::npos) return std::nullopt;
    Comparison comparison{.option = std::string(text.substr(0, equals)), .values = {}};
    for (const std::string_view value : parts_of(text.substr(equals + 1))) {
        if (std::ranges::find(comparison.values, value) != comparison.values.end()) return std::nullopt;
        comparison.values.emplace_back(value);
    }
    if (comparison.values.size() < 2 || comparison.values.size() > most_panels) return std::nullopt;
    return comparison;
}

double FrameChoices::trail_seconds() const {
    const auto trails = std::ranges::find(overlay, OverlayKind::trails, &OverlayItem::kind);
    return trails == overlay.end() ? 0.0 : trails->seconds.value_or(1.0);
}

std::vector<long> plan_ghosts(const FrameChoices& choices, const Rational& dt) {
    std::vector<long> steps;
    for (const Rational& time : choices.ghosts) steps.push_back(step_of("--ghosts", time, dt));
    std::ranges::sort(steps);
    return steps;
}

std::span<const FrameOption> frame_options() {
    return frame_table;
}

long steps_a_frame(const Rational& fps, const Rational& dt, const Rational& play_speed) {
    const Rational steps = play_speed / (fps * dt);
    if (!steps.is_whole()) {
        const std::string at_speed =
            play_speed == Rational{1, 1} ? "" : fmt::format(" at --play-speed {}", to_text(play_speed));
        throw UsageError("--fps {}{}: a frame must be a whole number of steps of {} s; rates that fit are {}",
                         to_text(fps), at_speed, to_text(dt), rates_that_fit(fps, dt, play_speed));
    }
    return static_cast<long>(steps.numerator);
}

Frame Frames::operator[](std::size_t n) const {
    if (are_stills()) return stills_[n];
    return {static_cast<long>(n) * every_, fmt::format("frame_{:06}.png", n)};
}

bool Frames::has(std::string_view name) const {
    if (are_stills()) return std::ranges::find(stills_, name, &Frame::name) != stills_.end();
    if (!name.starts_with("frame_") || !name.ends_with(".png")) return false;
    const auto number = parse_integer(name.substr(6, name.size() - 10), 0);
    return number && static_cast<std::size_t>(*number) < size_ &&
           (*this)[static_cast<std::size_t>(*number)].name == name;
}

Frames plan_frames(const FrameChoices& choices, const Rational& dt, long steps) {
    std::vector<Frame> frames;
    if (choices.at.empty()) {
        const long every = steps_a_frame(choices.film_rate(), dt, choices.play_speed);
        return {every, static_cast<std::size_t>(steps / every) + 1};
    }
    for (const Rational& time : choices.at) {
        const long step = step_of("--at", time, dt);
        if (step > steps) {
            throw UsageError("--at {}: must be within the {} s of the run (--seconds)", to_text(time),
                             to_text(dt * Rational{steps, 1}));
        }
        std::string name = to_text(time);
        std::replace(name.begin(), name.end(), '/', '_');
        frames.push_back({step, "at_" + name + "s.png"});
    }
    std::stable_sort(frames.begin(), frames.end(), [](const Frame& a, const Frame& b) { return a.step < b.step; });
    const auto same = [](const Frame& a, const Frame& b) { return a.step == b.step; };
    frames.erase(std::unique(frames.begin(), frames.end(), same), frames.end());
    return frames;
}

}  // namespace pushfactor::demos
