// Files of measured numbers, means with their errors, measured tosses of a cube onto a board (the y axis is up),
// how far computed ones are from them, and the law of contact with which an engine follows them best.
#pragma once

#include "demos/base/platform/progress.h"
#include "engine/base/math.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
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

// A pose with its velocities, from which a toss goes on.
struct Restart {
    Pose pose;
    engine::Vector3 velocity, angular_velocity;
};

struct Toss {
    std::vector<Pose> frames;
    Restart start;  // the first frame, with velocities as its authors smoothed them
};

// Those of the folder of measured motion. Throws RunError for a missing or damaged file.
std::vector<Toss> read_tosses(const std::filesystem::path& folder);

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

// Mean over the frames after the first.
PoseError mean_error(const Toss& toss, const std::vector<Pose>& poses);

// The frames with which contacts begin: the lowest corner within 3 mm of the board, after one in which it was not.
std::vector<std::size_t> bounces(const Toss& toss, double board);

// Which face is up: 1 to 3 for an axis of the body, negative for its other end.
int upper_face(const engine::Quaternion& orientation);

using Tosses = std::vector<Toss>;

// Poses of a toss that starts like this under a law, one per frame, the start first.
using Engine = std::function<std::vector<Pose>(const Restart& start, const Law& law, std::size_t frames)>;

// Every other toss is fitted (`first` 0), the others are judged (1); of each half one of five for the quick report.
Tosses half_of(const Tosses& all, std::size_t first, bool quick);

// Values of friction and restitution, evenly spaced, for a board of this height.
struct LawGrid {
    std::vector<double> frictions, restitutions;
    Mean board;
};
LawGrid law_grid(const Tosses& tosses, bool quick);

// Mean error of position of every toss, for all restitutions with this friction.
std::vector<double> errors_with(const Engine& engine, const Tosses& tosses, const LawGrid& grid, double friction,
                                const StopCheck& check);

class LawFit {
  public:
    // `errors`: those of errors_with() for each friction of the grid.
    LawFit(LawGrid grid, std::vector<std::vector<double>> errors);

    const LawGrid& grid() const { return grid_; }
    double error(std::array<std::size_t, 2> at) const { return error(at, whole_); }  // mean over all tosses

    // The least mean error of the grid, then the vertex of the parabola through its neighbours along each axis.
    Law best() const { return best(whole_); }
    // One standard deviation of each number, over tosses that are drawn again, with replacement.
    Law spread() const;

  private:
    double error(std::array<std::size_t, 2> at, const std::vector<std::size_t>& of) const;
    Law best(const std::vector<std::size_t>& of) const;

    LawGrid grid_;
    std::vector<std::vector<double>> errors_;  // by friction
    std::vector<std::size_t> whole_;           // 0, 1, ... all tosses
};

struct Judged {
    std::vector<double> position, angle;  // mean of each toss, edges and degrees
    std::vector<bool> right;              // with the measured face on top at the end
    std::vector<std::vector<Pose>> poses;
};
Judged judge(const Engine& engine, const Tosses& tosses, const Law& law);

struct ErrorsAt {
    double at = 0.0;  // s since the first contact, or which bounce it is after, from 1
    std::vector<double> position{}, angle{};

    void add(const PoseError& error) {
        position.push_back(error.position);
        angle.push_back(error.angle);
    }
};
// By frame since the first contact, up to 0.6 s, and just before each next contact, or at the end: while there are
// ten tosses.
std::vector<ErrorsAt> errors_over_time(const Tosses& tosses, const Judged& judged, const Law& law);
std::vector<ErrorsAt> errors_by_bounce(const Tosses& tosses, const Judged& judged, const Law& law);

// A number of an engine, with one standard deviation.
struct Result {
    std::string what;
    double value = 0.0;
    std::optional<double> error{};
};
// All numbers that stand for the engine: the fitted law, errors on the other tosses, restarts after 0.1 s.
std::vector<Result> results_of(const Engine& engine, const LawFit& fit, const Tosses& tosses, const Judged& judged);

}  // namespace pushfactor::demos::reports::reality
