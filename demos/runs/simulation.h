// Steps a scene and measures its state after each step. No files; a clock only if the caller passes one.
#pragma once

#include "demos/runs/checkpoint.h"
#include "demos/runs/scene.h"
#include "demos/runs/step_division.h"
#include "demos/runs/worst_row.h"
#include "demos/scenes/motions/pose_reader.h"
#include "engine/bodies/diagnostics.h"
#include "engine/energy_account.h"
#include "engine/measures/penetration.h"

#include <optional>
#include <span>
#include <string_view>

namespace pushfactor::demos {

// Measurements of one step of the run, which is `substeps` engine steps: sweeps and work are summed; residual,
// length error and the numbers of unsolved or contradictory islands are the largest of any; rows, columns and other
// islands are those of the last.
struct Sample {
    long step = 0;
    double time = 0.0;                // s
    double kinetic_energy = 0.0;      // J
    double potential_energy = 0.0;    // J, zero at the origin
    double energy_gain = 0.0;         // J, beyond work from outside, one step late (energy_account.h)
    double max_speed = 0.0;           // m/s, from the stored momenta
    engine::Penetration penetration;  // of the state after the step
    double max_length_error = 0.0;    // m, of distance rows
    double residual = 0.0;            // m/s, natural map
    engine::StepCount count;
    int substeps = 1;
    std::string_view substep_rule;  // that required them; empty if none did
    bool too_few_substeps = false;  // it required more than are allowed
    std::optional<double> cpu_us;   // of the engine steps alone, if there is a clock

    // Bodies of the worst row; searched only in an unsolved step with the largest residual so far, and in the first
    // step with rows that contradict each other.
    std::optional<BodyPair> worst_unsolved, contradicting;
};

// Number of whole steps in settings.seconds.
long whole_steps(const Settings& settings);

// Name of a body of the world in messages.
std::string_view body_name(const BuiltScene& scene, int body);

class Simulation {
  public:
    using Clock = double (*)();  // us of CPU time of this thread

    // Shifts the initial momenta back by half a step if the settings require it. With several threads the clock
    // counts the work of one only.
    Simulation(BuiltScene scene, const Settings& settings, Clock clock = nullptr);
    // The same for the options of a run.
    explicit Simulation(const Choices& choices, Clock clock = nullptr);

    // Takes one step of settings.dt. Throws NonFiniteError if a number of the state or of the sample is not finite
    // afterwards; the simulation cannot be continued then.
    const Sample& advance();

    // Puts bodies where they were after this step, for pictures. Velocities, forces and measurements stay as they
    // were, so the simulation cannot be continued.
    void show(long step, std::span<const BodyPose> poses);

    // The current state, and the one before the last step.
    Checkpoint checkpoint() const;
    const Checkpoint& checkpoint_before() const { return before_; }

    const BuiltScene& scene() const { return scene_; }
    const Settings& settings() const { return settings_; }
    const Sample& sample() const { return sample_; }  // of the last step, or of the start

  private:
    // What engine steps change besides the scene and the sample.
    struct Progress {
        engine::EnergyAccount energy;
        double lag = 0.0;  // s, length of the last step: half of it ago the momenta are. 0 before the first one
        double largest_unsolved = 0.0;  // m/s, residual of any step that was not solved
        bool contradicted = false;      // whether rows of any step did so
    };

    void start();
    void divide_step(const engine::Penetration& start);
    bool take_parts(const engine::Penetration& start);
    void step_engine(double dt);
    void find_worst();
    void measure_state();
    void measure_penetration();
    void require_finite_sample() const;
    [[noreturn]] void fail(std::size_t body, std::string_view quantity) const;

    BuiltScene scene_;
    Settings settings_;
    StepDivision division_;
    Clock clock_;
    engine::collision::Detector detector_;  // for penetrations
    Sample sample_;
    Progress progress_;
    Checkpoint before_;
};

}  // namespace pushfactor::demos
