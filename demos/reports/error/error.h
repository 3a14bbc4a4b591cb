// The report on errors: work-precision diagrams, true errors of runs, the methods that it compares, scene by scene,
// the points of their sweeps, systems of single moments, and the convergence of scenes to themselves. A new solver
// or integrator only needs a line in experiments.cpp.
#pragma once

#include "demos/reports/study.h"
#include "engine/system/system_equation.h"

#include <span>

namespace pushfactor::demos::reports::error {

// Work-precision diagrams, double logarithmic: lower left is better.

struct WorkPoint {
    double error = 0.0;  // drawn at the left border if below the axis range
    double work = 0.0;
    std::string label{};  // the value of the knob
    bool failed = false;  // drawn hollow at the right border
};

struct WorkLine {
    std::string name;
    std::string colour{};  // name in the palette
    int dash = 1;          // gnuplot's dash type
    int mark = 7;          // gnuplot's point type
    std::vector<WorkPoint> points{};
};

// The point of the least work whose error is at most `error`, and its line; null if none reaches it.
std::pair<const WorkLine*, const WorkPoint*> cheapest(std::span<const WorkLine> lines, double error);

// Colour of a method by the solver that its name begins with, the same on all plots: "pgs, cold".
std::string colour_of_solver(const std::string& method);

struct WorkPlot {
    std::string name;  // of the files
    std::string error_axis, work_axis;
    std::vector<WorkLine> lines{};
    std::vector<WorkLine> theory{};  // thin and grey, with their names
    bool front = true;               // mark the Pareto front; not for lines that are no alternatives
};

// Writes NAME.dat and, where gnuplot is installed, draws it as NAME.png and NAME.svg, with the machine in small
// print below. Adds the files to the plate; without gnuplot its caption says what to install.
void draw_work_plot(WorkPlot plot, const StudyRun& run, SectionContent& plate);

// A section with the plot, named like it.
Section work_section(const WorkPlot& plot, const std::string& heading, const std::string& caption,
                     const StudyRun& run, SectionContent plate = {});

// Indices of the points that no other point dominates (less error or work, and no more of the other), by rising
// error; of equal points the first.
std::vector<std::size_t> pareto_front(std::span<const WorkPoint> points);

// A position in letter widths, y upwards.
using Place = Eigen::Vector2d;

struct Segment {
    Place from, to;
};

// The centre of each label next to its point, so that none covers a point or another label, and if possible no
// line; none where there is no room. Labels stay inside the area from (0, 0) to `corner`.
std::vector<std::optional<Place>> place_labels(const std::vector<Place>& points,
                                               const std::vector<std::string>& labels,
                                               const std::vector<Segment>& lines, const Place& corner);

// True errors of runs: against closed forms, exact motion or converged forces, never against another program or a
// finer run.

struct NamedError {
    std::string name;  // with its unit, "sideways_m"; without one it is relative
    double value = 0.0;
};

// One number of what is added to it over the steps of a run, 0 of nothing.
class ErrorNumber {
  public:
    enum Kind { root_mean, largest, middle, last, sum };  // root_mean: of squares

    ErrorNumber(std::string name, Kind kind) : name_(std::move(name)), kind_(kind) {}
    void add(double value);
    NamedError result() const;

  private:
    std::string name_;
    Kind kind_;
    double value_ = 0.0;
    long count_ = 0;
    std::vector<double> all_;  // for the median
};
using ErrorNumbers = std::vector<ErrorNumber>;

struct TrueError {
    ErrorNumbers numbers;  // the plotted one first
    std::function<void(const Simulation& now, ErrorNumbers& numbers)> look;

    void observe(const Simulation& now) { look(now, numbers); }  // after each step
    std::vector<NamedError> result() const;
};
using MakeTrueError = std::function<TrueError(const Simulation& start)>;

// Reference forces: the same system solved down to a negligible residual.
//
//   e_f = sqrt( (lambda - lambda*)^T A (lambda - lambda*) / (lambda*^T A lambda*) )
//
// the relative error of the accelerations that the constraint forces give. Box on box has more contacts than
// unknown reactions, so lambda* is not unique; A lambda* is, and e_f sees nothing else.
//
// Symbols: A = J M^-1 J^T [1/kg], lambda answer and lambda* converged answer [N], e_f [1].
//
// e_f, the largest over the columns. None if the converged forces are zero.
std::optional<double> force_error(const engine::SystemEquation& system, const engine::Columns& lambda,
                                  const engine::Columns& converged);

// The converged forces of at most 1e-10 m/s (natural map), starting from `guess`. None if no solver converges.
std::optional<engine::Columns> converged_forces(const engine::SystemEquation& system, const engine::Columns& guess);

// Closed form of one of the parting cubes after `steps` engine steps, with everything solved exactly.
struct PartingCube {
    double start = 0.0;  // m, height of the centre
    double rest = 0.0;   // m, height without overlap
    engine::Correction push;
    double dt = 0.0;        // s, of an engine step
    double gravity = 10.0;  // m/s^2

    // Of the centre. Persistent: all leave with beta (rest - start) / dt in the first step and fly. Single-frame:
    // the distance to the rest height shrinks by the factor 1 - beta per step. No push: it stays.
    double height(long steps) const;
    double upward_speed(long steps) const;  // m/s, stored velocity
};

// Stack: distance from the exact rest positions and error of the force below the lowest cube, over the last second;
// the largest sideways motion, zero if solved exactly, over the run. Valid for a jittered stack too: while the
// common centre of mass of everything above a face is above that face, forces at its corners can stop the fall
// without rotation, and the velocities of an exact solution are unique. So each cube lands straight below its
// start.
TrueError rest_error(const Simulation& start);

// Structures that should stand: distance from the start, RMS over the bodies and the last second.
TrueError standing_error(const Simulation& start);

// Intersecting stack: distance from PartingCube, over all steps and cubes.
TrueError parting_error(const Simulation& start);

// The scene's own measure: for the wave the angle against the exact motion of two angles.
TrueError scene_error(const Simulation& start);

// A column of equal touching balls: e_f of the first step, whose exact forces are the weights above.
TrueError column_error(const Simulation& start);

// The chain: distance of the balls from the exact motion of balls on massless bars, over all steps.
TrueError chain_error(const Simulation& start);

// Piles: the deepest overlap, the median of the steps; its largest value.
TrueError overlap_error(const Simulation& start);

// Free bodies: distance of the corners of boxes from the parabola and the closed form of free rotation, over all
// steps; its parts due to flight (of all bodies) and to rotation, and the largest relative change of rotational
// energy. Throws engine::InvalidInput for a box whose motion scenes::FreeRotation does not cover.
TrueError free_error(const Simulation& start);

// Everything else: the median of e_f against converged forces of the same system, over thirty moments of the run.
TrueError converged_error(const Simulation& start);

// Options from a text: "solver=pgs tolerance=0".
OptionTexts options(const std::string& text);

struct Method {
    std::string name;                   // in legends
    std::string differs;                // options that differ from the sweep's, as such a text
    std::string knob;                   // the varied option: iterations, tolerance, substeps, small-steps or dt
    std::string colour;                 // name in the palette
    int dash = 1;                       // gnuplot's dash type: 1 is solid
    int mark = 7;                       // gnuplot's point type
    double order = 0.0;                 // of the error in dt, 0 if unknown
    int moves = 1;                      // of all bodies per engine step, more than 1 for composed steps
    bool flies = false;                 // the exact solution of the method flies up, so "fly" is no failure
    std::vector<std::string> values{};  // of the knob
};

struct Experiment {
    std::string scene;   // of the catalogue or of assets/scenes
    std::string name{};  // of the part and its files: the scene's, unless that has several experiments
    std::string title{};
    std::string common;   // options that all methods share beside the preset default, as such a text
    std::string seconds;  // of the run
    MakeTrueError error;
    std::string error_axis{};
    std::string caption{};
    std::vector<Method> methods{};
    double contraction = 0.0;               // of the error per sweep of cold pgs, 0 if unknown
    std::optional<double> clock_seconds{};  // s, of the timed runs, if a shorter run costs the same per second
    int timed_runs = 5;                     // per point
    bool solves = true;                     // false: there are no rows, and work is counted in moves
};

// The experiments. `quick`: few values and short runs.
std::vector<Experiment> error_experiments(bool quick);

// The options at one value of the knob, and the run.
OptionTexts options_at(const Experiment& sweep, const Method& method, const std::string& value);
Choices run_at(const Experiment& sweep, const Method& method, const std::string& value);

// cos^2(pi / 2n): contraction of the error per Gauss-Seidel sweep in a column of n equal balls on the ground.
double column_contraction(int balls);

// CPU seconds of the engine steps per simulated second, up to the last finite step. Scenes that come to rest cost
// more at first, so the medians of the first two seconds and of the last one are listed too.
struct CpuShare {
    double min = 0.0, median = 0.0, p95 = 0.0;
    double first_two_seconds = 0.0, last_second = 0.0;
};

// One point of a sweep: a scene with a method at one value of its knob, run once for errors and work, and several
// times for CPU time, which measuring would distort. Points of other engines have the same columns and measures,
// and come from tests/compare error.
struct ErrorPoint {
    std::string scene, method, differences, knob, value;
    std::vector<NamedError> errors{};  // over all finite steps, the plotted one first
    double multiply_adds = 0.0;        // of the solver per simulated second, equal on every machine
    CpuShare cpu{};
    std::string outcome{};  // as in a summary, or non-finite
    bool failed = false;    // it blew up or fell, which the exact solution does not

    double error() const { return errors.front().value; }
};

// Outcomes that the exact solution does not have; to fly up is none of them for some methods.
bool means_failure(const std::string& outcome);

ErrorPoint run_point(const Experiment& sweep, const Method& method, const std::string& value,
                     const StopCheck& check);

// The same as a piece, and the point of its result.
Piece piece_of(const Experiment& sweep, const Method& method, const std::string& value);
ErrorPoint point_in(const Json& result, const Method& method);

// The smallest value that at least 95 % of `values`, which is not empty, do not exceed.
double percentile_95(std::vector<double> values);

Table table_of(const std::vector<ErrorPoint>& points);  // error.csv, one line per point and error

// Points of other engines, with the columns of error.csv. Throws UsageError with the line and what it must be.
std::vector<ErrorPoint> read_error_points(const std::filesystem::path& file);

// Those about the scene and the measure that is plotted for it.
std::vector<ErrorPoint> about(std::vector<ErrorPoint> points, const std::string& scene, const std::string& measure);

// Error against CPU time: of `ours` the methods that none of ours beats everywhere, and all others, in grey.
std::vector<WorkLine> lines_beside(std::span<const WorkLine> ours, std::span<const ErrorPoint> others);

// A line per other method: its smallest error, the CPU time for that, and the least of ours for that error or less.
TextTable who_is_faster(std::span<const WorkLine> ours, std::span<const ErrorPoint> others);

// A frozen problem: the system equation of one step as a solver gets it, without the scene; as a JSON file other
// programs can solve it too (demos/FORMATS.md). Such problems at hard moments of scenes show the convergence of
// each solver without the effect of its errors on the run.
inline constexpr int frozen_version = 1;  // of the format

class FrozenProblem {
  public:
    // The system of the world's last step.
    FrozenProblem(std::string name, const engine::World& world);

    // Such a system. Its `diagonal` and `digests` are computed here, and its rows are `rows`.
    FrozenProblem(std::string name, std::vector<engine::ConstraintRow> rows, engine::SystemEquation system,
                  engine::Columns guess);

    FrozenProblem(FrozenProblem&& other) noexcept = default;  // rows stay where they are

    const std::string& name() const { return name_; }
    const engine::SystemEquation& system() const { return system_; }
    const engine::Columns& guess() const { return guess_; }  // N, rows x columns
    engine::Columns zero() const { return engine::Columns::Zero(guess_.rows(), guess_.cols()); }

    std::string text() const;

  private:
    std::string name_;
    std::vector<engine::ConstraintRow> rows_;
    engine::SystemEquation system_;  // its rows are rows_
    engine::Columns guess_;
};

struct FrozenMoment {
    std::string name;     // "stack of 5, landing"
    std::string scene;    // of the catalogue or of assets/scenes
    OptionTexts options;  // "seconds" is the moment
};

std::vector<FrozenMoment> hard_moments(bool quick);

// Moments of contacts with Coulomb's friction and nothing else, which is what collections of contact problems have.
struct ContactMoment {
    std::string name;  // a file name: "wall_3_at_0.5s"
    Choices choices;   // `settings.seconds` is the moment
};

// Stacks, heaps, walls, houses of cards and arches, ten each: five members at two moments; of each kind one with
// `quick`.
std::vector<ContactMoment> contact_moments(bool quick);

// Runs the scene up to the moment and freezes its system.
FrozenProblem freeze(const FrozenMoment& moment, const StopCheck& check);
FrozenProblem freeze(const std::string& name, const Choices& choices, const StopCheck& check);

inline const std::vector<std::string> frozen_columns{"problem", "method", "iterations", "residual_m_per_s",
                                                     "work_multiply_adds"};

// Results of every solver, cold and warm, over iterations, as lines of frozen.csv. `dense` is left out above 200
// rows: it gives the same as `pgs` at cubic cost.
Table solve_frozen(const FrozenProblem& problem, bool quick);

// The same as a piece. Its result has the number of "rows" and "columns" of the system, and the "lines" of
// solve_frozen().
Piece piece_of(const FrozenMoment& moment, bool quick);

// Lines of the plot of one problem: all but `dense`, whose work would compress the others.
std::vector<WorkLine> lines_of(const TextTable& lines);

// Convergence of each scene to itself at smaller steps. In several windows, runs restart from states of one run
// with the smallest step, so that chaos does not grow beyond a window.
//
//   e_c(h) = sqrt( mean over windows and bodies of |x^h - x^h_min|^2 ) at the end of a window
//   order p = log2( e_c(2h) / e_c(h) )
//
// Symbols: h step [s], h_min the smallest [s], x position [m], e_c [m].
void add_consistency(bool quick, Pieces& pieces);  // a scene each

// consistency.csv and its section.
void add_consistency(StudyRun& run);

}  // namespace pushfactor::demos::reports::error
