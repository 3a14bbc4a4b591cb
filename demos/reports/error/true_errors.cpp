#include "demos/base/text/median.h"
#include "demos/reports/error/error.h"
#include "demos/scenes/exact_motions/free_rotation.h"
#include "demos/scenes/exact_motions/hanging_chain.h"

#include <cmath>
#include <memory>
#include <numbers>

namespace pushfactor::demos::reports::error {

namespace {

using engine::Body;
using engine::Columns;
using engine::Vector3;

// Without the ground or the body of the world.
std::vector<Body> movable_bodies(const Simulation& simulation) {
    std::vector<Body> movable = simulation.scene().world.bodies;
    std::erase_if(movable, [](const Body& body) { return body.is_static(); });
    return movable;
}

// The sum of the normal forces between the ground, body 0, and the lowest cube [N].
double bottom_force(const engine::World& world) {
    double sum = 0.0;
    for (Eigen::Index j = 0; j < world.lambda().rows(); ++j) {
        const engine::ConstraintRow& row = world.rows()[static_cast<std::size_t>(j)];
        if (row.label.kind != engine::RowKind::contact || std::min(row.body_a, row.body_b) != 0) continue;
        sum += world.lambda()(j, world.lambda().cols() - 1);
    }
    return sum;
}

double turning_energy(const std::vector<Body>& bodies) {
    double sum = 0.0;
    for (const Body& body : bodies) sum += 0.5 * angular_velocity(body).dot(body.angular_momentum);
    return sum;
}

struct Flight {
    Vector3 start, velocity;                         // m, m/s
    Vector3 half_size = Vector3::Zero();             // m, of a box
    std::optional<scenes::FreeRotation> rotation{};  // of a box
};

// From the description, because the start kick may already have changed the momenta.
Flight flight_of(const BodyDescription& described, const Body& body) {
    Flight flight{.start = described.position, .velocity = described.velocity};
    if (const auto* box = std::get_if<BoxShape>(&described.shape)) {
        flight.half_size = 0.5 * box->size;
        flight.rotation.emplace(
            scenes::FreeBody{.inertia = body.inverse_inertia.cwiseInverse(),
                             .start = described.orientation,
                             .angular_rate = described.orientation.conjugate() * described.angular_velocity});
    }
    return flight;
}

}  // namespace

void ErrorNumber::add(double value) {
    ++count_;
    value_ = kind_ == largest ? std::max(value_, value) : kind_ == last ? value : value_ + value;
    if (kind_ == middle) all_.push_back(value);
}

NamedError ErrorNumber::result() const {
    if (kind_ == middle) return {name_, median(all_)};
    return {name_, kind_ == root_mean && count_ > 0 ? std::sqrt(value_ / static_cast<double>(count_)) : value_};
}

std::vector<NamedError> TrueError::result() const {
    std::vector<NamedError> errors;
    for (const ErrorNumber& number : numbers) errors.push_back(number.result());
    return errors;
}

// Stacks: the first body is the ground, the cubes follow from below.
TrueError rest_error(const Simulation& start) {
    std::vector<Vector3> starts;
    double weight = 0.0;  // N, of all cubes
    for (const Body& cube : movable_bodies(start)) {
        starts.push_back(cube.position);
        weight += cube.mass() * start.scene().gravity.norm();
    }
    const auto look = [=, heights = start.scene().standing.value().rest_heights](const Simulation& now,
                                                                                 ErrorNumbers& numbers) {
        const engine::World& world = now.scene().world;
        const bool last_second = now.sample().time > now.settings().seconds - 1.0;
        for (std::size_t i = 0; i < starts.size(); ++i) {
            const Vector3 &from = starts[i], &position = world.bodies[i + 1].position;
            numbers[1].add(std::hypot(position.x() - from.x(), position.z() - from.z()));
            if (last_second) numbers[0].add((position - Vector3(from.x(), heights[i], from.z())).squaredNorm());
        }
        if (last_second) numbers[2].add(std::pow(bottom_force(world) / weight - 1.0, 2));
    };
    return {{{"rest_position_rms_m", ErrorNumber::root_mean},
             {"max_sideways_m", ErrorNumber::largest},
             {"bottom_force_rms", ErrorNumber::root_mean}},
            look};
}

TrueError standing_error(const Simulation& start) {
    const auto look = [bodies = movable_bodies(start), from = start.settings().seconds - 1.0](
                          const Simulation& now, ErrorNumbers& numbers) {
        if (now.sample().time <= from) return;
        const std::vector<Body> moved = movable_bodies(now);
        for (std::size_t i = 0; i < bodies.size(); ++i)
            numbers[0].add((moved[i].position - bodies[i].position).squaredNorm());
    };
    return {{{"moved_rms_m", ErrorNumber::root_mean}}, look};
}

TrueError parting_error(const Simulation& start) {
    const Settings& settings = start.settings();
    const std::vector<Body> bodies = movable_bodies(start);
    std::vector<PartingCube> cubes;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        cubes.push_back({.start = bodies[i].position.y(),
                         .rest = start.scene().standing.value().rest_heights[i],
                         .push = settings.contacts,
                         .dt = settings.dt.value() / settings.substeps.value_or(1),
                         .gravity = start.scene().gravity.norm()});
    }
    const auto look = [bodies, cubes](const Simulation& now, ErrorNumbers& numbers) {
        const long steps = now.sample().step * now.settings().substeps.value_or(1);
        for (std::size_t i = 0; i < cubes.size(); ++i) {
            const Body& body = now.scene().world.bodies[i + 1];
            const Vector3 exact(bodies[i].position.x(), cubes[i].height(steps), bodies[i].position.z());
            numbers[0].add((body.position - exact).squaredNorm());
            numbers[1].add(std::abs(velocity(body).y() - cubes[i].upward_speed(steps)));
        }
    };
    return {{{"position_rms_m", ErrorNumber::root_mean}, {"max_upward_speed_m_per_s", ErrorNumber::largest}}, look};
}

TrueError scene_error(const Simulation& start) {
    const std::shared_ptr<SceneMeasure> measure = start.scene().measure(start.scene().world);
    ErrorNumbers numbers;
    for (const auto& [name, value] : measure->result()) numbers.emplace_back(name, ErrorNumber::last);
    const auto look = [measure](const Simulation& now, ErrorNumbers& errors) {
        measure->observe(now.scene().world);
        const auto result = measure->result();
        for (std::size_t i = 0; i < errors.size(); ++i) errors[i].add(std::abs(result[i].second));
    };
    return {numbers, look};
}

TrueError column_error(const Simulation&) {
    const auto look = [](const Simulation& now, ErrorNumbers& numbers) {
        if (now.sample().step != 1) return;
        const engine::World& world = now.scene().world;
        const int count = static_cast<int>(world.bodies.size()) - 1;
        Columns exact = Columns::Zero(world.lambda().rows(), world.lambda().cols());
        for (Eigen::Index j = 0; j < exact.rows(); ++j) {
            const engine::ConstraintRow& row = world.rows()[static_cast<std::size_t>(j)];
            if (row.label.kind != engine::RowKind::contact) continue;
            const int above = count - std::min(row.body_a, row.body_b);  // balls
            exact.row(j).setConstant(above * world.bodies.back().mass() * now.scene().gravity.norm());
        }
        numbers[0].add(force_error(world.system(), world.lambda(), exact).value_or(0.0));
    };
    return {{{"force_error_first_step", ErrorNumber::last}}, look};
}

TrueError chain_error(const Simulation& start) {
    const std::vector<Body> balls = movable_bodies(start);
    const auto count = static_cast<Eigen::Index>(balls.size());
    scenes::HangingChain chain{.lengths = Eigen::VectorXd(count),
                               .masses = Eigen::VectorXd(count),
                               .moments = Eigen::VectorXd::Zero(count),  // bars hold the centres
                               .gravity = start.scene().gravity.norm()};
    scenes::ChainSwing swing{.angles = Eigen::VectorXd(count), .rates = Eigen::VectorXd::Zero(count)};
    Vector3 above = Vector3::Zero();
    for (Eigen::Index i = 0; i < count; ++i) {
        const Body& ball = balls[static_cast<std::size_t>(i)];
        const Vector3 bar = ball.position - above;
        chain.lengths[i] = bar.norm();
        chain.masses[i] = ball.mass();
        swing.angles[i] = std::atan2(bar.x(), -bar.y());
        above = ball.position;
    }
    const auto look = [chain, swing](const Simulation& now, ErrorNumbers& numbers) mutable {
        // s, of the exact motion: its own error is some 1e-11 m, below that of the finest runs.
        constexpr double longest_step = 1.0 / 15360.0;
        const double dt = now.settings().dt.value();
        const int steps = std::max(1, static_cast<int>(std::lround(dt / longest_step)));
        swing = advance(chain, std::move(swing), dt, steps);
        const std::vector<Eigen::Vector2d> exact = places(chain, swing);
        const std::vector<Body> bodies = movable_bodies(now);
        for (std::size_t i = 0; i < exact.size(); ++i) {
            const double square = (bodies[i].position - Vector3(exact[i].x(), exact[i].y(), 0.0)).squaredNorm();
            numbers[0].add(square);
            numbers[1].add(std::sqrt(square));
        }
    };
    return {{{"position_rms_m", ErrorNumber::root_mean}, {"end_of_chain_m", ErrorNumber::last}}, look};
}

TrueError overlap_error(const Simulation&) {
    const auto look = [](const Simulation& now, ErrorNumbers& numbers) {
        for (ErrorNumber& number : numbers) number.add(now.sample().penetration.max);
    };
    return {{{"deepest_overlap_median_m", ErrorNumber::middle}, {"deepest_overlap_m", ErrorNumber::largest}}, look};
}

TrueError free_error(const Simulation& start) {
    const BuiltScene& scene = start.scene();
    std::vector<Flight> flights;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        flights.push_back(flight_of(scene.bodies[i], scene.world.bodies[i]));
    const auto look = [flights, energy = turning_energy(scene.world.bodies)](const Simulation& now,
                                                                             ErrorNumbers& numbers) mutable {
        const auto& bodies = now.scene().world.bodies;
        const double time = now.sample().time;
        for (std::size_t i = 0; i < flights.size(); ++i) {
            Flight& flight = flights[i];
            const Vector3 exact = flight.start + time * flight.velocity + 0.5 * time * time * now.scene().gravity;
            const double flown = (bodies[i].position - exact).squaredNorm();
            numbers[1].add(flown);
            if (!flight.rotation) continue;
            const engine::Quaternion turned = flight.rotation->at(time);
            const engine::Matrix3 apart = bodies[i].orientation.toRotationMatrix() - turned.toRotationMatrix();
            // Mean over all corners: terms linear in the offset cancel between opposite ones.
            numbers[0].add(flown + (apart * flight.half_size.asDiagonal()).squaredNorm());
            numbers[2].add(std::pow(bodies[i].orientation.angularDistance(turned) * 180.0 / std::numbers::pi, 2));
        }
        numbers[3].add(std::abs(turning_energy(bodies) / energy - 1.0));
    };
    return {{{"corners_rms_m", ErrorNumber::root_mean},
             {"flight_rms_m", ErrorNumber::root_mean},
             {"angle_rms_deg", ErrorNumber::root_mean},
             {"turning_energy_max", ErrorNumber::largest}},
            look};
}

TrueError converged_error(const Simulation& start) {
    const long every = std::max(1L, whole_steps(start.settings()) / 30);
    const auto look = [every](const Simulation& now, ErrorNumbers& numbers) {
        const engine::World& world = now.scene().world;
        if (now.sample().step % every != 0 || world.rows().empty()) return;
        numbers[1].add(now.sample().residual);
        const auto converged = converged_forces(world.system(), world.lambda());
        if (!converged) {
            numbers[2].add(1.0);
        } else if (const auto error = force_error(world.system(), world.lambda(), *converged)) {
            numbers[0].add(*error);
        }
    };
    return {{{"force_error_median", ErrorNumber::middle},
             {"residual_median_m_per_s", ErrorNumber::middle},
             {"moments_without_reference", ErrorNumber::sum}},
            look};
}

double PartingCube::height(long steps) const {
    const auto n = static_cast<double>(steps);
    if (push.kind == engine::PushKind::none) return start;
    if (push.kind == engine::PushKind::persistent) {
        return start + push.beta * (rest - start) * n - gravity * dt * dt * n * (n - 1.0) / 2.0;
    }
    return rest - (rest - start) * std::pow(1.0 - push.beta, n);
}

double PartingCube::upward_speed(long steps) const {
    if (push.kind != engine::PushKind::persistent) return 0.0;
    return push.beta * (rest - start) / dt - gravity * dt * static_cast<double>(steps - 1);
}

}  // namespace pushfactor::demos::reports::error
