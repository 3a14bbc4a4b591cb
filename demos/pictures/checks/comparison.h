// A picture beside the file that is expected, and how much it may differ from it.
#pragma once

#include "demos/pictures/checks/verdict.h"
#include "renderer/images/difference.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace pushfactor::demos::checks {

// At most `share` (0..1) of the pixels may differ by more than `level` (0..255) in any channel.
struct Limit {
    int level = 0;
    double share = 0.0;
};

struct Tolerance {
    std::vector<Limit> limits{};   // all hold
    std::optional<double> flip{};  // largest mean FLIP error, 0..1; replaces the limits

    // `mean_flip` counts only with `flip`.
    bool accepts(const renderer::ImageDifference& difference, double mean_flip) const;

    // What is not accepted, in numbers.
    std::string complaint(const renderer::ImageDifference& difference, double mean_flip) const;

    std::string text() const;
};

// "2:0.05%,16:0.005%"; "2" stands for "2:0%". None if it is not of this form.
std::optional<std::vector<Limit>> parse_limits(std::string_view text);

// Equal pixels: for pictures of the same program and driver.
inline Tolerance exactly() {
    return {.limits = {{0, 0.0}}};
}

// For another driver, which rounds some pixels on edges differently.
inline Tolerance usual() {
    return {.limits = {{2, 0.0005}, {16, 0.00005}}};
}

using Bytes = std::vector<std::uint8_t>;

// The verdict, and for the page, if it does not hold, three PNG files; empty where there is none.
struct Compared {
    PictureVerdict verdict{};
    Bytes expected{}, actual{}, difference{};
};

struct Comparison {
    Tolerance tolerance;
    std::string film{};       // mark of the frames
    bool same_bytes = false;  // equal pictures are expected to be equal files: a quick look before decoding
};

// Thread-safe. Throws renderer::RendererError for an image that cannot be encoded.
// `file` is the actual PNG file where there is one, whose opacity counts.
Compared compare(const Comparison& how, const std::filesystem::path& expected, const renderer::Image& actual,
                 const Bytes& file = {});

// The bytes of a file; none if there is no such file. Throws OutputError if it cannot be read.
std::optional<Bytes> read_bytes(const std::filesystem::path& file);

// The verdict on a picture that cannot be compared.
PictureVerdict refused(const std::string& name, Finding finding, const std::string& text);

}  // namespace pushfactor::demos::checks
