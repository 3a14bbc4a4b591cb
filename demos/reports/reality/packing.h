// Packings of spheres and regular solids in a box: poured, and then shaken.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::reality {

// Those of assets/measured/packings.csv, shares of the volume, +-0.01: regular solids by Baker and Kudrolli (2010,
// arXiv 1008.1728); none where nothing was measured.
struct MeasuredPacking {
    std::string solid;
    std::optional<double> loose{}, dense{};
};
// Throws UsageError for a missing or damaged file.
std::vector<MeasuredPacking> read_packings();

// A box with a square floor.
struct Container {
    double width = 0.0;     // m
    int bodies = 0;         // all of the volume of a ball of 1 m
    double friction = 0.0;  // of bodies and walls
    int shakes = 0;
};

// Shares of the volume away from walls and surface after pouring and after shaking, each with its error: one
// standard deviation of the mean over eight parts of the region.
struct Packing {
    double loose = 0.0, loose_error = 0.0, dense = 0.0, dense_error = 0.0;
    double deepest = 0.0;  // m, overlap at the end
};
Packing packed(const std::string& solid, const Container& container, const std::function<void()>& check);

}  // namespace pushfactor::demos::reports::reality
