#include "demos/simulation.h"

#include "demos/errors.h"
#include "engine/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pushfactor::demos {

namespace {

double max_length_error(std::span<const engine::ConstraintRow> rows) {
    double largest = 0.0;
    for (const engine::ConstraintRow& row : rows) {
        if (row.label.kind == engine::RowKind::distance) largest = std::max(largest, std::abs(row.label.gap));
    }
    return largest;
}

bool wants_kick(const Scene& scene, const Settings& settings) {
    const StartKick choice = settings.start_kick;
    if (settings.integrator != Integrator::euler) return false;
    if (choice != StartKick::where_it_fits) return choice == StartKick::on;
    const bool at_rest = std::all_of(scene.world.bodies.begin(), scene.world.bodies.end(), [](const auto& body) {
        return body.linear_momentum.isZero(0.0) && body.angular_momentum.isZero(0.0);
    });
    return at_rest && !scene.contacts;
}

}  // namespace

long whole_steps(const Settings& settings) {
    // A hair more than the quotient, so that "10 seconds" of 1/60 s are 600 steps and not 599.
    return static_cast<long>(std::floor(settings.seconds / settings.dt.value() * (1.0 + 1e-12) + 1e-9));
}

Simulation::Simulation(Scene scene, const Settings& settings, Clock clock)
    : scene_(std::move(scene)), settings_(settings), clock_(clock) {
    if (wants_kick(scene_, settings)) scene_.world.kick_back_half(engine_dt());
    measure_state();
}

const Sample& Simulation::advance() {
    const long step = sample_.step + 1;
    sample_ = {};
    sample_.step = step;
    sample_.time = (settings_.dt * Rational{step, 1}).value();
    sample_.substeps = settings_.substeps;
    if (clock_) sample_.cpu_us = 0.0;
    for (int i = 0; i < settings_.substeps; ++i) step_engine();
    require_finite();
    measure_state();
    return sample_;
}

void Simulation::step_engine() {
    const double before = clock_ ? clock_() : 0.0;
    const engine::StepCount so_far = sample_.count;
    sample_.count = scene_.step(scene_.world, engine_dt());
    if (clock_) *sample_.cpu_us += clock_() - before;
    sample_.count.sweeps += so_far.sweeps;
    sample_.count.multiply_adds += so_far.multiply_adds;
    sample_.residual = std::max(sample_.residual, natural_residual(scene_.world.system(), scene_.world.lambda()));
    sample_.max_length_error = max_length_error(scene_.world.rows());
}

void Simulation::measure_state() {
    const std::span<const engine::Body> bodies = scene_.world.bodies;
    sample_.kinetic_energy = engine::kinetic_energy(bodies);
    sample_.potential_energy = engine::potential_energy(bodies, scene_.gravity);
    sample_.max_speed = engine::max_speed(bodies);
    if (scene_.contacts) sample_.penetration = engine::penetration(bodies, scene_.contacts->colliders());
}

void Simulation::require_finite() const {
    const auto found = engine::find_non_finite(scene_.world.bodies);
    if (!found) return;
    throw NonFiniteError(fmt::format("{}: body {}: {} is not finite after step {} ({} s)", scene_.name,
                                     scene_.bodies[found->body].name, found->quantity, sample_.step, sample_.time));
}

}  // namespace pushfactor::demos
