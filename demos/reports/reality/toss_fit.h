// The law of contact with which an engine follows tosses best, and how far it goes on others.
#pragma once

#include "demos/platform/progress.h"
#include "demos/reports/reality/tosses.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::reality {

using Tosses = std::vector<Toss>;

// Poses of a toss that starts like this under a law, one per frame, the start first.
using Engine = std::function<std::vector<Pose>(const Restart& start, const Law& law, std::size_t frames)>;

// Every other toss is fitted (`first` 0), the others are judged (1); of each half one of five for the quick report.
Tosses half_of(const Tosses& all, std::size_t first, bool quick);

// Where the cubes of these tosses lie at the end, m: the height of the board is measured there best.
Mean board_of(const Tosses& tosses);

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
