// Files of measured numbers, means with their errors, measured tosses of a cube onto a board, and how far computed
// ones are from them. The y axis is up.
#pragma once

#include "engine/base/math.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos::reports::reality {

// The lines of a CSV file of numbers below its heading, which has to be `columns`; a file that ends in .gz is
// decompressed. Throws RunError for a missing or damaged file.
std::vector<std::vector<double>> numbers_of(const std::filesystem::path& file, const std::string& columns);

struct Mean {
    double value = 0.0, error = 0.0;  // one standard deviation of the mean
};
inline Mean mean_of(const std::vector<double>& values) {
    Mean mean;
    const auto count = static_cast<double>(values.size());
    if (values.empty()) return mean;
    for (const double value : values) mean.value += value / count;
    if (values.size() < 2) return mean;
    double squares = 0.0;
    for (const double value : values) squares += (value - mean.value) * (value - mean.value);
    mean.error = std::sqrt(squares / (count * (count - 1.0)));
    return mean;
}

// Of a share of `count` trials, the interval that has it with 95 % (Wilson 1927).
inline std::pair<double, double> confidence(double share, int count) {
    constexpr double z = 1.96;
    const double n = count, middle = share + z * z / (2.0 * n);
    const double reach = z * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
    return {(middle - reach) / (1.0 + z * z / n), (middle + reach) / (1.0 + z * z / n)};
}

struct Pose {
    engine::Vector3 position;  // m
    engine::Quaternion orientation;
};

// The tosses of assets/measured, of ContactNets (Pfrommer, Halm, Posa 2020): at 148 Hz, each from its first frame.
constexpr double edge = 0.1048, mass = 0.37;   // m, kg
constexpr double moment_of_inertia = 0.00081;  // kg m^2; of a uniform cube it would be 0.00068
constexpr int frames_per_second = 148;

struct Toss {
    std::vector<Pose> frames;
    engine::Vector3 velocity, angular_velocity;  // at the first frame, as its authors smoothed them
};

// Those of the folder of measured motion. Throws RunError for a missing or damaged file.
std::vector<Toss> read_tosses(const std::filesystem::path& folder);

// A pose with its velocities, from which a toss goes on.
struct Restart {
    Pose pose;
    engine::Vector3 velocity, angular_velocity;
};
Restart start_of(const Toss& toss);
// That of frame `at`, with the velocities that fit the frames around it best (straight lines through five).
Restart restart(const Toss& toss, std::size_t at);

struct Law {
    double friction = 0.0, restitution = 0.0;
    double board = 0.0;  // m, its height
};

struct PoseError {
    double position = 0.0;  // in edges
    double angle = 0.0;     // degrees
};
PoseError between(const Pose& measured, const Pose& computed);

// Mean over the frames after the first.
PoseError mean_error(const Toss& toss, const std::vector<Pose>& poses);

// The frames with which contacts begin: the lowest corner within 3 mm of the board, after one in which it was not.
std::vector<std::size_t> bounces(const Toss& toss, double board);

// Which face is up: 1 to 3 for an axis of the body, negative for its other end.
int upper_face(const engine::Quaternion& orientation);

}  // namespace pushfactor::demos::reports::reality
