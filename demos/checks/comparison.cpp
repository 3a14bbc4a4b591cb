#include "demos/checks/comparison.h"

#include "demos/text/errors.h"
#include "renderer/base/renderer_error.h"
#include "renderer/images/flip.h"
#include "renderer/images/png.h"
#include "renderer/images/read_png.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numeric>

namespace pushfactor::demos::checks {

namespace {

// Worse than any difference of pixels.
constexpr double worst = 2.0;

void refuse(Compared& compared, Finding finding, std::string text) {
    compared.verdict.finding = finding;
    compared.verdict.badness = worst;
    compared.verdict.text = std::move(text);
}

// Fills in what differs between two images of one size.
void look(const Tolerance& tolerance, const renderer::Image& expected, const renderer::Image& actual,
          Compared& compared) {
    const renderer::ImageDifference difference(expected, actual);
    if (!difference.any()) return;
    std::vector<float> errors;
    std::optional<double> mean;
    if (tolerance.flip) {
        errors = renderer::flip(expected, actual);
        mean = std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    }
    PictureVerdict& verdict = compared.verdict;
    verdict.badness = mean ? *mean : difference.rms() / 255.0;
    verdict.text = tolerance.complaint(difference, mean);
    verdict.finding = tolerance.accepts(difference, mean) ? Finding::within_tolerance : Finding::differs;
    if (verdict.holds()) return;
    compared.difference = renderer::encode_png(mean ? heat_map(expected, errors) : heat_map(expected, actual));
}

}  // namespace

Compared compare(const Comparison& how, const std::filesystem::path& expected, const renderer::Image& actual,
                 const Bytes& file) {
    Compared compared;
    compared.actual = file;
    compared.verdict.name = expected.filename();
    const std::optional<Bytes> bytes = read_bytes(expected);
    if (compared.actual.empty() && (how.same_bytes || !bytes)) {
        compared.actual = renderer::encode_png(actual, {.dots_per_inch = 0.0, .film = how.film});
    }
    if (!bytes) {
        refuse(compared, Finding::missing, "missing");
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
            refuse(compared, Finding::other_size,
                   fmt::format("another size: {}x{} instead of {}x{} pixels", actual.width, actual.height,
                               image.width, image.height));
        }
        if (compared.verdict.holds()) return {.verdict = compared.verdict};
        compared.expected = *bytes;
    } catch (const renderer::RendererError& error) {
        refuse(compared, Finding::unreadable, error.what());
    }
    if (compared.actual.empty()) {
        compared.actual = renderer::encode_png(actual, {.dots_per_inch = 0.0, .film = how.film});
    }
    return compared;
}

std::optional<Bytes> read_bytes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        if (!std::filesystem::exists(file)) return std::nullopt;
        throw OutputError(fmt::format("cannot read {}: {}", file.string(), std::strerror(errno)));
    }
    return Bytes(std::istreambuf_iterator<char>(stream), {});
}

PictureVerdict without(const std::string& name, const std::string& text) {
    return {.name = name, .finding = Finding::missing, .badness = worst, .text = text};
}

}  // namespace pushfactor::demos::checks
