// Files of measured numbers, measured tosses of a cube onto a board, and how far computed ones are from them. The y
// axis is up.
#pragma once

#include "engine/base/math.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::reality {

// The lines of a CSV file of numbers below its heading, which has to be `columns`; a file that ends in .gz is
// decompressed. Throws RunError for a missing or damaged file.
std::vector<std::vector<double>> numbers_of(const std::filesystem::path& file, const std::string& columns);

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
