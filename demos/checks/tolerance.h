// How much a picture may differ from the expected one.
#pragma once

#include "renderer/images/difference.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos::checks {

// At most `share` (0..1) of the pixels may differ by more than `level` (0..255) in any channel.
struct Limit {
    int level = 0;
    double share = 0.0;
};

struct Tolerance {
    std::vector<Limit> limits{};   // all hold
    std::optional<double> flip{};  // largest mean FLIP error, 0..1; replaces the limits

    bool accepts(const renderer::ImageDifference& difference, std::optional<double> mean_flip) const;

    // What is not accepted, in numbers.
    std::string complaint(const renderer::ImageDifference& difference, std::optional<double> mean_flip) const;

    std::string text() const;
};

// "2:0.05%,16:0.005%"; "2" stands for "2:0%". None if it is not of this form.
std::optional<std::vector<Limit>> parse_limits(std::string_view text);

// Equal pixels: for pictures of the same program and driver.
Tolerance exactly();

// For another driver, which rounds some pixels on edges differently.
Tolerance usual();

}  // namespace pushfactor::demos::checks
