// Measurements of a whole run, collected step by step: the numbers of the summary.
#pragma once

#include "demos/base/text/median.h"
#include "demos/runs/measured_errors.h"
#include "demos/runs/obstacles.h"
#include "demos/runs/simulation.h"

#include <deque>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

// Outcome of a run, judged over its last second: the worst that applies, in this order. L is the size of the
// smallest body, g gravity, v_s = sqrt(g L), or L per second without gravity.
enum class Outcome {
    // A body without contacts and distances is above its start and rises faster than v_s, or moves and is higher
    // above all starts than their extent and than 20 L. In a standing scene: any body that rises so, or is more
    // than 20 L from the line from its start to its place of rest.
    fly,
    tunnel,  // a centre is behind a static plane, or has gone through a static box, sphere or polyhedron
    torn,    // a distance without a force limit is wrong by more than half of its length (stretch.h)
    fall,    // in a standing scene: a centre is more than L/2 below the lower of its start and its rest height
    moving,  // faster than 0.1 v_s: a centre, or the corners of a box about it
    creep,   // moved by more than 1e-5 L in the last second
    jitter,  // faster than 1e-4 v_s without that
    rest
};
std::string_view name_of(Outcome outcome);

// Number of engine steps per step of a run, and the rules that required them.
struct SubstepCount {
    long steps = 0;
    long sum = 0;
    int largest = 0;
    std::map<std::string_view, long> steps_by_rule;  // steps of more than one part
    long short_steps = 0;                            // that needed more parts than are allowed

    double mean() const { return steps > 0 ? static_cast<double>(sum) / static_cast<double>(steps) : 0.0; }
    void add(const Sample& sample);
};

// Unsolved steps: steps of the run that left an island with a residual above the upper tolerance.
struct UnsolvedSteps {
    struct Place {
        long step = 0;
        double time = 0.0;                 // s
        std::optional<BodyPair> bodies{};  // of the row with the largest residual, where it was searched
    };

    long of = 0;                        // steps of the run
    long count = 0;                     // that were not solved
    long contradicting = 0;             // with rows that contradict each other
    double worst_residual = 0.0;        // m/s, of all steps
    double worst_unsolved = 0.0;        // m/s, residual of what was not solved
    std::optional<Place> first, worst;  // the worst of what was not solved
    std::optional<Place> first_contradicting;

    void add(const Sample& sample);
};

// Islands by method, summed over all steps of a run.
struct IslandCount {
    long kept = 0, swept = 0, exact = 0, in_small_steps = 0;
};

// Impacts followed within the steps of a run.
struct ImpactCount {
    long all = 0;
    int largest = 0;       // in one step
    long short_steps = 0;  // with more than are followed
};

// Sleeping bodies.
struct AtRest {
    int bodies = 0;               // after the last step
    std::optional<double> since;  // s, since when all movable bodies have been sleeping, if they are
};

class Measurements {
  public:
    // At the start of the run. `wanted`: names of costly measures of the scene that are made; null: all. Throws
    // UsageError for another name.
    explicit Measurements(const Simulation& simulation, const std::vector<std::string>* wanted = nullptr);

    void observe(const Simulation& simulation);  // after each step

    Outcome outcome() const;
    double max_penetration() const { return max_penetration_; }                               // m
    double max_length_error() const { return max_length_error_; }                             // m
    double max_speed_last_second() const { return largest_last_second(&Moment::max_speed); }  // m/s
    double max_upward_speed() const { return max_upward_speed_; }  // m/s, stored velocity
    double median_residual() const { return median(residuals_); }  // m/s
    double initial_energy() const { return initial_energy_; }      // J
    double final_energy() const { return energy_; }                // J
    double energy_gain() const { return energy_gain_; }            // J, the largest, beyond work from outside
    // J, the largest kinetic energy of the run, at least that of all bodies at the speed v_s (see Outcome).
    double motion_energy() const { return std::max(max_kinetic_energy_, falling_energy_); }
    double max_speed() const { return max_speed_; }          // m/s, of the run
    double start_stretch() const { return start_stretch_; }  // error as a share of the length (stretch.h), largest
    double max_stretch() const { return max_stretch_; }      // the same after any step
    double max_off_axis() const { return max_off_axis_; }    // m sideways from the start
    // m, farthest from the place at 10 s
    std::optional<double> drift_after_10_s() const { return at_10_s_ ? std::optional(drift_) : std::nullopt; }
    std::optional<double> lean_time() const { return lean_time_; }  // s, standing scenes
    std::optional<double> fall_time() const { return fall_time_; }  // s, standing scenes
    const std::vector<double>& cpu_us() const { return cpu_us_; }   // one per step, if there is a clock
    double max_kinetic_energy_last_second() const { return largest_last_second(&Moment::kinetic_energy); }  // J
    const SubstepCount& substeps() const { return substeps_; }
    const UnsolvedSteps& unsolved() const { return unsolved_; }
    const IslandCount& islands() const { return islands_; }
    const ImpactCount& impacts() const { return impacts_; }
    const AtRest& at_rest() const { return at_rest_; }
    // The scene's own measures; none where it was not made.
    std::vector<std::pair<std::string, std::optional<double>>> of_scene() const;
    const std::optional<MeasuredSum>& measured() const { return measured_; }  // of a scene with measured motion
    std::vector<double> heights() const;                                      // m, movable bodies at the end

  private:
    using Positions = std::vector<engine::Vector3>;  // movable bodies

    // Extremes of some consecutive steps, and the positions after the last of them.
    struct Moment {
        double max_speed = 0.0;
        double fastest = 0.0;  // m/s, of a centre or of corners about it
        double kinetic_energy = 0.0;
        bool flew = false, tunnelled = false, tore = false, fell = false;
        Positions positions;
    };

    double largest_last_second(double Moment::*what) const;
    void add_counts(const Sample& sample);
    void remember(const Moment& moment, long step);
    Moment judge(const Simulation& simulation, double stretch) const;
    void watch_standing(double time);
    bool flies(const engine::World& world, const engine::Body& body, std::size_t i) const;
    bool strayed(std::size_t i, const engine::Vector3& position) const;
    double lowest_place(std::size_t i) const;  // m, the lower of start and rest height

    std::optional<Standing> standing_;
    std::unique_ptr<SceneMeasure> scene_measure_;
    bool makes_scene_measure_ = true;
    double size_ = 1.0;        // m, L
    double speed_ = 1.0;       // m/s, v_s
    long steps_a_moment_ = 1;  // so that the last second is at most 60 moments, however small the steps
    std::size_t moments_a_second_ = 1;
    Positions start_;
    Eigen::AlignedBox3d starts_;  // around all of them
    Positions latest_;
    std::vector<double> corners_;  // m from the centre, of movable boxes; 0 for other shapes
    std::vector<bool> held_;       // movable bodies, by a distance
    Obstacles obstacles_;
    bool passed_ = false;  // an obstacle has been, by any body
    std::optional<Positions> at_10_s_;
    std::deque<Moment> window_;  // moments of the last second, and the one before

    double max_penetration_ = 0.0, max_length_error_ = 0.0, max_upward_speed_ = 0.0, max_off_axis_ = 0.0;
    double initial_energy_ = 0.0, energy_ = 0.0, energy_gain_ = 0.0, drift_ = 0.0;
    double max_kinetic_energy_ = 0.0, falling_energy_ = 0.0, max_speed_ = 0.0;
    double start_stretch_ = 0.0, max_stretch_ = 0.0;
    std::optional<double> lean_time_, fall_time_;
    std::vector<double> residuals_, cpu_us_;
    SubstepCount substeps_;
    UnsolvedSteps unsolved_;
    IslandCount islands_;
    ImpactCount impacts_;
    AtRest at_rest_;
    MeasuredErrors measured_errors_;
    std::optional<MeasuredSum> measured_;
};

}  // namespace pushfactor::demos
