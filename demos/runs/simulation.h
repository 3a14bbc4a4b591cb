// Steps a scene and measures its state after each step. No files, no clock: who wants times brings a clock.
#pragma once

#include "demos/runs/checkpoint.h"
#include "demos/runs/scene.h"
#include "demos/runs/step_division.h"
#include "demos/runs/worst_row.h"
#include "engine/bodies/diagnostics.h"
#include "engine/energy_account.h"
#include "engine/measures/penetration.h"

#include <optional>
#include <string_view>

namespace pushfactor::demos {

// What one step of the run was like. A run step is `substeps` engine steps: their sweeps are summed; residual,
// length error and the islands that were not solved or have rows that contradict each other are the largest of any;
// rows, columns and other islands are those of the last.
struct Sample {
    long step = 0;
    double time = 0.0;                // s
    double kinetic_energy = 0.0;      // J
    double potential_energy = 0.0;    // J, zero at the origin
    double energy_gain = 0.0;         // J, beyond what came from outside, a step ago (energy_account.h)
    double max_speed = 0.0;           // m/s, from the stored momenta
    engine::Penetration penetration;  // of the state after the step
    double max_length_error = 0.0;    // m, of distance rows
    double residual = 0.0;            // m/s, natural map
    engine::StepCount count;
    int substeps = 1;
    std::string_view substep_rule;  // that asked for the most of them; empty when none did
    bool too_few_substeps = false;  // it asked for more than there may be
    std::optional<double> cpu_us;   // of the engine steps alone, when there is a clock

    // Between whom, looked for only where they are asked for: an unsolved step whose residual is the largest so
    // far, and the first step whose rows contradict each other.
    std::optional<BodyPair> worst_unsolved, contradicting;
};

// How many whole steps fit into settings.seconds.
long whole_steps(const Settings& settings);

// How messages call a body of the world.
std::string_view body_name(const BuiltScene& scene, int body);

class Simulation {
  public:
    using Clock = double (*)();  // us of CPU time of this thread

    // Gives the momenta half a kick back first where the settings ask for it. Of a scene with several threads
    // a clock counts the work of one.
    Simulation(BuiltScene scene, const Settings& settings, Clock clock = nullptr);
    // Of the scene and with the settings of a run.
    explicit Simulation(const Choices& choices, Clock clock = nullptr);

    // One step of settings.dt. Throws NonFiniteError when a number of the state or of the sample is not finite
    // afterwards; the simulation cannot go on then.
    const Sample& advance();

    // The state now, and the one before the last step began.
    Checkpoint checkpoint() const;
    const Checkpoint& checkpoint_before() const { return before_; }

    const BuiltScene& scene() const { return scene_; }
    const Settings& settings() const { return settings_; }
    const Sample& sample() const { return sample_; }  // of the last step; of the start before the first

  private:
    void start();
    void divide_step();
    void step_engine(double dt);
    void find_worst(double residual);
    void measure_state();
    void require_finite_state() const;
    void require_finite_sample() const;
    [[noreturn]] void fail(std::size_t body, std::string_view quantity) const;

    BuiltScene scene_;
    Settings settings_;
    StepDivision division_;
    Clock clock_;
    engine::collision::Detector detector_;  // of penetrations
    Sample sample_;
    engine::EnergyAccount energy_;
    Checkpoint before_;
    double largest_unsolved_ = 0.0;  // m/s, residual of any engine step that was not solved
    bool contradicted_ = false;      // rows of any engine step
};

}  // namespace pushfactor::demos
