#include "demos/pictures/checks/comparison.h"

#include "demos/base/platform/output_file.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/numbers.h"
#include "renderer/base/renderer_error.h"
#include "renderer/images/flip.h"
#include "renderer/images/png.h"
#include "renderer/images/read_png.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numeric>

namespace pushfactor::demos::checks {

namespace {

bool keeps(const Limit& limit, const renderer::ImageDifference& difference) {
    return difference.share_above(limit.level) <= limit.share;
}

std::string percent(double share) {
    return fmt::format("{:.3g} %", 100.0 * share);
}

std::optional<Limit> parse_limit(std::string_view text) {
    const std::size_t colon = text.find(':');
    const auto level = parse_integer(text.substr(0, colon));
    if (!level || *level < 0 || *level > 255) return std::nullopt;
    if (colon == std::string_view::npos) return Limit{*level, 0.0};
    std::string_view share = text.substr(colon + 1);
    if (!share.ends_with('%')) return std::nullopt;
    share.remove_suffix(1);
    const auto value = parse_number(share);
    if (!value || *value < 0.0 || *value > 100.0) return std::nullopt;
    return Limit{*level, *value / 100.0};
}

// Fills in what differs between two images of one size.
void look(const Tolerance& tolerance, const renderer::Image& expected, const renderer::Image& actual,
          Compared& compared) {
    const renderer::ImageDifference difference(expected, actual);
    if (!difference.any()) return;
    std::vector<float> errors;
    double mean = 0.0;
    if (tolerance.flip) {
        errors = renderer::flip(expected, actual);
        mean = std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    }
    PictureVerdict& verdict = compared.verdict;
    verdict.badness = tolerance.flip ? mean : difference.rms() / 255.0;
    verdict.text = tolerance.complaint(difference, mean);
    verdict.finding = tolerance.accepts(difference, mean) ? Finding::within_tolerance : Finding::differs;
    if (verdict.holds()) return;
    compared.difference =
        renderer::encode_png(tolerance.flip ? heat_map(expected, errors) : heat_map(expected, actual));
}

}  // namespace

bool Tolerance::accepts(const renderer::ImageDifference& difference, double mean_flip) const {
    if (flip) return mean_flip <= *flip;
    return std::ranges::all_of(limits, [&](const Limit& limit) { return keeps(limit, difference); });
}

std::string Tolerance::complaint(const renderer::ImageDifference& difference, double mean_flip) const {
    const std::string largest = fmt::format("the largest by {} levels", difference.largest());
    if (flip) {
        return fmt::format("mean FLIP error {:.3g} ({} allowed); {} of the pixels differ, {}", mean_flip, *flip,
                           percent(difference.share_above(0)), largest);
    }
    const auto broken = std::ranges::find_if(limits, [&](const Limit& limit) { return !keeps(limit, difference); });
    const Limit limit = broken == limits.end() ? Limit{} : *broken;
    const std::string more = limit.level > 0 ? fmt::format(" by more than {} levels", limit.level) : "";
    const std::string allowed = limit.share > 0.0 ? fmt::format(" ({} allowed)", percent(limit.share)) : "";
    return fmt::format("{} of the pixels differ{}{}, {}", percent(difference.share_above(limit.level)), more,
                       allowed, largest);
}

std::string Tolerance::text() const {
    if (flip) return fmt::format("mean FLIP error at most {}", *flip);
    std::string text;
    for (const Limit& limit : limits) {
        if (!text.empty()) text += ", ";
        if (limit.level == 0 && limit.share == 0.0) return "to the byte";
        text += limit.share > 0.0
                    ? fmt::format("at most {} of the pixels by more than {}", percent(limit.share), limit.level)
                    : fmt::format("none by more than {}", limit.level);
    }
    return text + " levels of 255";
}

std::optional<std::vector<Limit>> parse_limits(std::string_view text) {
    std::vector<Limit> limits;
    for (const std::string_view part : parts_of(text)) {
        const auto limit = parse_limit(part);
        if (!limit) return std::nullopt;
        limits.push_back(*limit);
    }
    return limits;
}

Compared compare(const Comparison& how, const std::filesystem::path& expected, const renderer::Image& actual,
                 const Bytes& file) {
    Compared compared;
    compared.actual = file;
    const std::string name = compared.verdict.name = expected.filename();
    const std::optional<Bytes> bytes = read_bytes(expected);
    const auto encode = [&] {
        if (compared.actual.empty()) compared.actual = renderer::encode_png(actual, {.film = how.film});
    };
    if (how.same_bytes || !bytes) encode();
    if (!bytes) {
        compared.verdict = refused(name, Finding::missing, "missing");
        return compared;
    }
    if (how.same_bytes && compared.actual == *bytes) return {.verdict = compared.verdict};
    try {
        const renderer::Image image = renderer::decode_png(*bytes);
        if (image.width == actual.width && image.height == actual.height) {
            look(how.tolerance, image, actual, compared);
            if (compared.verdict.holds() && (renderer::has_opacity(*bytes) || renderer::has_opacity(file))) {
                const renderer::Image opaque{.width = actual.width,
                                             .height = actual.height,
                                             .rgb = std::vector<std::uint8_t>(actual.rgb.size(), 255)};
                look(how.tolerance, renderer::decode_opacity(*bytes),
                     file.empty() ? opaque : renderer::decode_opacity(file), compared);
                if (!compared.verdict.holds()) compared.verdict.text = "opacity: " + compared.verdict.text;
            }
        } else {
            compared.verdict = refused(name, Finding::other_size,
                                       fmt::format("another size: {}x{} instead of {}x{} pixels", actual.width,
                                                   actual.height, image.width, image.height));
        }
        if (compared.verdict.holds()) return {.verdict = compared.verdict};
        compared.expected = *bytes;
    } catch (const renderer::RendererError& error) {
        compared.verdict = refused(name, Finding::unreadable, error.what());
    }
    encode();
    return compared;
}

std::optional<Bytes> read_bytes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        if (!std::filesystem::exists(file)) return std::nullopt;
        throw OutputError("cannot read {}: {}", file.string(), std::strerror(errno));
    }
    return Bytes(std::istreambuf_iterator<char>(stream), {});
}

PictureVerdict refused(const std::string& name, Finding finding, const std::string& text) {
    constexpr double worst = 2.0;  // than any difference of pixels
    return {.name = name, .finding = finding, .badness = worst, .text = text};
}

}  // namespace pushfactor::demos::checks
