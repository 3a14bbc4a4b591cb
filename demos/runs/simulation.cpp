#include "demos/runs/simulation.h"

#include "demos/base/text/errors.h"
#include "demos/options/choices.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pushfactor::demos {

namespace {

double max_length_error(std::span<const engine::ConstraintRow> rows) {
    double largest = 0.0;
    for (const engine::ConstraintRow& row : rows) {
        const bool holds = row.label.kind == engine::RowKind::distance || row.label.kind == engine::RowKind::joint;
        if (holds) largest = std::max(largest, std::abs(row.label.gap));
    }
    return largest;
}

bool wants_kick(const BuiltScene& scene, const Settings& settings) {
    const StartKick choice = settings.start_kick;
    if (is_rattle(settings.scheme)) return false;
    if (choice != StartKick::where_it_fits) return choice == StartKick::on;
    // A motor may give its speed in the first step.
    const auto is_driven = [](const engine::Joint& joint) { return joint.hinge && joint.hinge->motor; };
    if (scene.joints && std::ranges::any_of(scene.joints->joints(), is_driven)) return false;
    // What is taken from a force of the first step that ends is given back by nothing.
    const auto ends = [&](const engine::PokeForce* force) {
        return force->poke().from < settings.dt.value() && force->poke().until < engine::infinity;
    };
    if (std::ranges::any_of(scene.pokes, ends)) return false;
    const bool at_rest = std::all_of(scene.world.bodies.begin(), scene.world.bodies.end(), [](const auto& body) {
        return body.linear_momentum.isZero(0.0) && body.angular_momentum.isZero(0.0);
    });
    return at_rest && !scene.contacts;
}

// Index of the body with the largest number in its state; the first of several.
std::size_t most_extreme(std::span<const engine::Body> bodies) {
    const auto extreme = [](const engine::Body& body) {
        return std::max({body.position.cwiseAbs().maxCoeff(), body.linear_momentum.cwiseAbs().maxCoeff(),
                         body.angular_momentum.cwiseAbs().maxCoeff()});
    };
    const auto found = std::max_element(bodies.begin(), bodies.end(),
                                        [&](const auto& a, const auto& b) { return extreme(a) < extreme(b); });
    return static_cast<std::size_t>(found - bodies.begin());
}

}  // namespace

long whole_steps(const Settings& settings) {
    // Slightly more than the quotient, so that rounding cannot make 599 steps of 10 s at 1/60 s.
    return static_cast<long>(std::floor(settings.seconds / settings.dt.value() * (1.0 + 1e-12) + 1e-9));
}

std::string_view body_name(const BuiltScene& scene, int body) {
    const auto index = static_cast<std::size_t>(body);
    return index < scene.bodies.size() ? std::string_view(scene.bodies[index].name) : "world";
}

Simulation::Simulation(BuiltScene scene, const Settings& settings, Clock clock)
    : scene_(std::move(scene)),
      settings_(settings),
      division_(division_of(scene_, settings)),
      clock_(clock),
      progress_{.energy = engine::EnergyAccount(scene_.gravity)} {
    if (scene_.contacts) detector_.broad_phase().leave_out(scene_.contacts->filter());
    start();
    progress_.energy.open(scene_.world.bodies, settings_.dt.value(), scene_.world.stored_energy());
    measure_state();
    measure_penetration();
}

Simulation::Simulation(const Choices& choices, Clock clock)
    : Simulation(build_scene(choices), choices.settings, clock) {}

void Simulation::start() {
    const double dt = settings_.dt.value();
    if (scene_.parts_before && !is_rattle(settings_.scheme)) progress_.lag = dt / division_.parts();
    // The rules need the forces of a first solve.
    if (division_.has_rules() && !scene_.parts_before) scene_.world.prepare(dt);
    if (!wants_kick(scene_, settings_)) return;
    StepDivision first = division_;
    scene_.world.kick_back_half(dt / first.divide(scene_.world, dt));
}

const Sample& Simulation::advance() {
    const long step = sample_.step + 1;
    const engine::Penetration start = std::move(sample_.penetration);
    sample_ = {};
    sample_.step = step;
    sample_.time = (settings_.dt * Rational{step, 1}).value();
    if (clock_) sample_.cpu_us = 0.0;
    take_checkpoint(scene_, division_.level(), before_);
    divide_step(start);
    measure_state();
    require_finite_sample();
    return sample_;
}

void Simulation::show(long step, std::span<const BodyPose> poses) {
    sample_.step = step;
    sample_.time = (settings_.dt * Rational{step, 1}).value();
    for (const BodyPose& pose : poses) {
        engine::Body& body = scene_.world.bodies[pose.body];
        body.position = pose.position;
        body.orientation = pose.orientation;
    }
}

// Takes the step, and takes it again while its result shows that it needs more parts.
void Simulation::divide_step(const engine::Penetration& start) {
    division_.divide(scene_.world, settings_.dt.value());
    const Sample sample = sample_;
    const Progress progress = progress_;
    while (!take_parts(start)) {
        go_back(scene_, before_);
        const std::optional<double> spent = sample_.cpu_us;
        sample_ = sample;
        sample_.cpu_us = spent;
        progress_ = progress;
    }
    sample_.substep_rule = division_.rule();
    sample_.too_few_substeps = division_.is_short();
}

// Returns false, perhaps before the end, if these parts do not suffice.
bool Simulation::take_parts(const engine::Penetration& start) {
    const double dt = settings_.dt.value();
    const int parts = division_.parts();
    sample_.substeps = 0;
    for (int done = 0; done < parts; ++done) {
        step_engine(dt / parts);
        if (const auto found = engine::find_non_finite(scene_.world.bodies)) fail(found->body, found->quantity);
        if (!division_.suffices(scene_.world, dt)) return false;
    }
    const double before = clock_ ? clock_() : 0.0;
    measure_penetration();
    if (clock_ && !division_.is_fixed()) *sample_.cpu_us += clock_() - before;  // it decides how the step is taken
    return division_.suffices_for(engine::deepening(start, sample_.penetration));
}

void Simulation::step_engine(double dt) {
    if (progress_.lag > 0.0 && dt != progress_.lag) scene_.world.change_step(progress_.lag, dt);
    if (!is_rattle(settings_.scheme)) progress_.lag = dt;
    progress_.energy.begin(scene_.world.bodies);
    const double before = clock_ ? clock_() : 0.0;
    const engine::StepCount so_far = sample_.count;
    sample_.count = scene_.step(scene_.world, dt);
    if (clock_) *sample_.cpu_us += clock_() - before;
    progress_.energy.end(scene_.world, dt);
    sample_.count.sweeps += so_far.sweeps;
    sample_.count.row_updates += so_far.row_updates;
    sample_.count.impacts += so_far.impacts;
    sample_.count.impacts_cut_short = sample_.count.impacts_cut_short || so_far.impacts_cut_short;
    sample_.count.multiply_adds += so_far.multiply_adds;
    find_worst();
    sample_.count.unsolved_residual = std::max(sample_.count.unsolved_residual, so_far.unsolved_residual);
    sample_.count.islands_unsolved = std::max(sample_.count.islands_unsolved, so_far.islands_unsolved);
    sample_.count.islands_contradicting =
        std::max(sample_.count.islands_contradicting, so_far.islands_contradicting);
    sample_.residual = std::max(sample_.residual, scene_.world.residual());
    if (sample_.count.rows(engine::RowKind::distance) + sample_.count.rows(engine::RowKind::joint) > 0) {
        sample_.max_length_error = std::max(sample_.max_length_error, max_length_error(scene_.world.rows()));
    }
    ++sample_.substeps;
}

// Call while sample_.count is that of the engine step that has just ended.
void Simulation::find_worst() {
    if (sample_.count.unsolved_residual > progress_.largest_unsolved) {
        progress_.largest_unsolved = sample_.count.unsolved_residual;
        sample_.worst_unsolved = worst_unsolved(scene_.world);
    }
    if (sample_.count.islands_contradicting > 0 && !progress_.contradicted) {
        progress_.contradicted = true;
        sample_.contradicting = worst_contradicting(scene_.world);
    }
}

void Simulation::measure_state() {
    const std::span<const engine::Body> bodies = scene_.world.bodies;
    sample_.kinetic_energy = engine::kinetic_energy(bodies);
    sample_.potential_energy = engine::potential_energy(bodies, scene_.gravity);
    sample_.energy_gain = progress_.energy.gain();
    sample_.max_speed = engine::max_speed(bodies);
}

void Simulation::measure_penetration() {
    if (!scene_.contacts) return;
    engine::Threads* const threads = scene_.world.threads_worth_calling();
    const auto measure = [&] {
        sample_.penetration =
            engine::penetration(scene_.world.bodies, scene_.contacts->colliders(), detector_, threads);
    };
    if (threads) {
        threads->keep_at_hand(measure);
    } else {
        measure();
    }
}

Checkpoint Simulation::checkpoint() const {
    Checkpoint now;
    take_checkpoint(scene_, division_.level(), now);
    return now;
}

// A finite state may still overflow squares in the measured numbers.
void Simulation::require_finite_sample() const {
    const std::array measured{std::pair{sample_.kinetic_energy, "kinetic energy"},
                              std::pair{sample_.potential_energy, "potential energy"},
                              std::pair{sample_.energy_gain, "energy gain"},
                              std::pair{sample_.max_speed, "speed"},
                              std::pair{sample_.penetration.max, "penetration"},
                              std::pair{sample_.penetration.rms, "penetration"},
                              std::pair{sample_.max_length_error, "length error"},
                              std::pair{sample_.residual, "residual"}};
    for (const auto& [value, quantity] : measured) {
        if (!std::isfinite(value)) fail(most_extreme(scene_.world.bodies), quantity);
    }
}

void Simulation::fail(std::size_t body, std::string_view quantity) const {
    throw NonFiniteError("{}: body {}: {} is not finite after step {} ({} s)", scene_.name,
                         body_name(scene_, static_cast<int>(body)), quantity, sample_.step, sample_.time);
}

}  // namespace pushfactor::demos
