#include "demos/runs/measurements.h"

#include "demos/base/text/errors.h"
#include "demos/runs/stretch.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace pushfactor::demos {

namespace {

using engine::Body;
using engine::Vector3;

template <typename Visit>
void for_movable(std::span<const Body> bodies, Visit visit) {
    std::size_t i = 0;
    for (const Body& body : bodies) {
        if (!body.is_static()) visit(body, i++);
    }
}

std::vector<Vector3> positions_of(const engine::World& world) {
    std::vector<Vector3> positions;
    for_movable(world.bodies, [&](const Body& body, std::size_t) { positions.push_back(body.position); });
    return positions;
}

double sideways(const Vector3& from, const Vector3& to) {
    return engine::elementary::hypot(to.x() - from.x(), to.z() - from.z());
}

// The length scale L of a scene [m]: size of the smallest movable body with contacts.
double judged_size(const BuiltScene& scene) {
    double size = std::numeric_limits<double>::infinity();
    if (!scene.contacts) return 1.0;
    for (const auto& collider : scene.contacts->colliders()) {
        const bool movable = !scene.world.bodies[static_cast<std::size_t>(collider.body)].is_static();
        if (movable) size = std::min(size, size_of(collider.shape));
    }
    return std::isfinite(size) ? size : 1.0;
}

// The speed scale v_s of a scene [m/s]: sqrt(g L), without gravity L per second.
double judged_speed(const BuiltScene& scene, double size) {
    const double gravity = scene.gravity.norm();
    return gravity > 0.0 ? std::sqrt(gravity * size) : size;
}

// Of the movable bodies: distance of their corners from the centre [m]; 0 for round shapes, which look the same
// when turned.
std::vector<double> corners_of(const BuiltScene& scene) {
    std::vector<double> corners;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (scene.world.bodies[i].is_static()) continue;
        const bool round = std::holds_alternative<SphereShape>(scene.bodies[i].shape);
        corners.push_back(round ? 0.0 : bounding_radius(scene.bodies[i]));
    }
    return corners;
}

// Per movable body whether a distance or a joint holds it.
std::vector<bool> held_in(const BuiltScene& scene) {
    std::vector<bool> all(scene.world.bodies.size(), false), held;
    each_held(scene, [&all](const auto& held_by) {
        all[static_cast<std::size_t>(held_by.body_a)] = true;
        all[static_cast<std::size_t>(held_by.body_b)] = true;
    });
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!scene.world.bodies[i].is_static()) held.push_back(all[i]);
    }
    return held;
}

// Whether no row of the last step acts on this body.
bool is_free(const engine::World& world, const Body& body) {
    const auto index = static_cast<int>(&body - world.bodies.data());
    return std::ranges::none_of(world.rows(), [index](const engine::ConstraintRow& row) {
        return row.body_a == index || row.body_b == index;
    });
}

}  // namespace

std::string_view name_of(Outcome outcome) {
    constexpr std::array names{"fly", "tunnel", "torn", "fall", "moving", "creep", "jitter", "rest"};
    return names[static_cast<std::size_t>(outcome)];
}

void SubstepCount::add(const Sample& sample) {
    ++steps;
    sum += sample.substeps;
    largest = std::max(largest, sample.substeps);
    if (!sample.substep_rule.empty()) ++steps_by_rule[sample.substep_rule];
    if (sample.too_few_substeps) ++short_steps;
}

void UnsolvedSteps::add(const Sample& sample) {
    const auto place = [&](const std::optional<BodyPair>& bodies) {
        return Place{sample.step, sample.time, bodies};
    };
    ++of;
    if (sample.count.islands_unsolved > 0) {
        ++count;
        if (!first) first = place(sample.worst_unsolved);
    }
    if (sample.count.islands_contradicting > 0) {
        ++contradicting;
        if (!first_contradicting) first_contradicting = place(sample.contradicting);
    }
    worst_residual = std::max(worst_residual, sample.residual);
    if (sample.count.unsolved_residual > worst_unsolved) {
        worst_unsolved = sample.count.unsolved_residual;
        worst = place(sample.worst_unsolved);
    }
}

Measurements::Measurements(const Simulation& simulation, const std::vector<std::string>* wanted)
    : standing_(simulation.scene().standing),
      scene_measure_(simulation.scene().measure ? simulation.scene().measure(simulation.scene().world) : nullptr),
      size_(judged_size(simulation.scene())),
      speed_(judged_speed(simulation.scene(), size_)),
      start_(positions_of(simulation.scene().world)),
      latest_(start_),
      corners_(corners_of(simulation.scene())),
      held_(held_in(simulation.scene())),
      obstacles_(simulation.scene()),
      measured_errors_(simulation.scene()) {
    if (!measured_errors_.empty()) measured_.emplace();
    if (wanted) {
        std::vector<std::string> names;
        if (scene_measure_) {
            for (const auto& [name, value] : scene_measure_->result()) names.push_back(name);
        }
        for (const std::string& name : *wanted) {
            if (std::ranges::find(names, name) != names.end()) continue;
            throw UsageError("--measure {}: must be a measure of the scene: {}", name,
                             names.empty() ? "it has none" : fmt::format("{}", fmt::join(names, ", ")));
        }
        makes_scene_measure_ = !wanted->empty() || !scene_measure_ || !scene_measure_->is_costly();
    }
    const double steps_a_second = std::max(1.0, std::round(1.0 / simulation.settings().dt.value()));
    steps_a_moment_ = static_cast<long>(std::ceil(steps_a_second / 60.0));
    moments_a_second_ = static_cast<std::size_t>(std::ceil(steps_a_second / static_cast<double>(steps_a_moment_)));
    for (const Vector3& position : start_) starts_.extend(position);
    const Sample& sample = simulation.sample();
    initial_energy_ = energy_ = sample.kinetic_energy + sample.potential_energy;
    max_penetration_ = sample.penetration.max;
    max_kinetic_energy_ = sample.kinetic_energy;
    max_speed_ = sample.max_speed;
    start_stretch_ = worst_stretch(simulation.scene());
    for_movable(simulation.scene().world.bodies, [&](const Body& body, std::size_t) {
        falling_energy_ += 0.5 * speed_ * speed_ / body.inverse_mass;
    });
    window_.push_back(
        {.max_speed = sample.max_speed, .kinetic_energy = sample.kinetic_energy, .positions = start_});
}

double Measurements::lowest_place(std::size_t i) const {
    const double start = start_[i].y();
    return standing_ ? std::min(start, standing_->rest_heights[i]) : start;
}

void Measurements::add_counts(const Sample& sample) {
    const engine::StepCount& count = sample.count;
    islands_.kept += count.islands_kept;
    islands_.swept += count.islands_swept;
    islands_.exact += count.islands_exact;
    islands_.in_small_steps += count.islands_in_small_steps;
    impacts_.all += count.impacts;
    impacts_.largest = std::max(impacts_.largest, count.impacts);
    impacts_.short_steps += count.impacts_cut_short;
    at_rest_.bodies = count.at_rest;
    const bool all_rest = count.at_rest == static_cast<int>(start_.size());
    at_rest_.since = all_rest ? at_rest_.since.value_or(sample.time) : std::optional<double>();
}

void Measurements::observe(const Simulation& simulation) {
    if (measured_) measured_->add(measured_errors_.at(simulation));
    const Sample& sample = simulation.sample();
    const Positions before = std::exchange(latest_, positions_of(simulation.scene().world));
    obstacles_.follow(simulation.scene());
    for (std::size_t i = 0; i < latest_.size() && !passed_; ++i)
        passed_ = obstacles_.is_passed(before[i], latest_[i]);

    energy_ = sample.kinetic_energy + sample.potential_energy;
    energy_gain_ = std::max(energy_gain_, sample.energy_gain);
    max_kinetic_energy_ = std::max(max_kinetic_energy_, sample.kinetic_energy);
    max_speed_ = std::max(max_speed_, sample.max_speed);
    const double stretch = worst_stretch(simulation.scene());
    max_stretch_ = std::max(max_stretch_, stretch);
    max_penetration_ = std::max(max_penetration_, sample.penetration.max);
    max_length_error_ = std::max(max_length_error_, sample.max_length_error);
    residuals_.push_back(sample.residual);
    if (sample.cpu_us) cpu_us_.push_back(*sample.cpu_us);
    substeps_.add(sample);
    unsolved_.add(sample);
    add_counts(sample);

    for_movable(simulation.scene().world.bodies, [&](const Body& body, std::size_t i) {
        max_upward_speed_ = std::max(max_upward_speed_, velocity(body).y());
        max_off_axis_ = std::max(max_off_axis_, sideways(start_[i], latest_[i]));
        if (at_10_s_) drift_ = std::max(drift_, (latest_[i] - (*at_10_s_)[i]).norm());
    });
    if (!at_10_s_ && sample.time >= 10.0) at_10_s_ = latest_;
    if (standing_) watch_standing(sample.time);
    if (scene_measure_ && makes_scene_measure_) scene_measure_->observe(simulation.scene().world);

    remember(judge(simulation, stretch), sample.step);
}

void Measurements::remember(const Moment& moment, long step) {
    if ((step - 1) % steps_a_moment_ == 0) {
        window_.push_back(moment);
        if (window_.size() > moments_a_second_ + 1) window_.pop_front();
        return;
    }
    Moment& last = window_.back();
    last.max_speed = std::max(last.max_speed, moment.max_speed);
    last.fastest = std::max(last.fastest, moment.fastest);
    last.kinetic_energy = std::max(last.kinetic_energy, moment.kinetic_energy);
    last.flew |= moment.flew;
    last.tunnelled |= moment.tunnelled;
    last.tore |= moment.tore;
    last.fell |= moment.fell;
    last.positions = moment.positions;
}

void Measurements::watch_standing(double time) {
    const double half_side = 0.5 * standing_->side;
    for (std::size_t i = 0; i < latest_.size(); ++i) {
        if (!fall_time_ && latest_[i].y() < lowest_place(i) - half_side) fall_time_ = time;
        if (!lean_time_ && sideways(start_[i], latest_[i]) > half_side) lean_time_ = time;
    }
}

bool Measurements::flies(const engine::World& world, const Body& body, std::size_t i) const {
    const Vector3& position = body.position;
    const bool rises = position.y() > start_[i].y() && velocity(body).y() > speed_;
    if (standing_) return rises || strayed(i, position);
    if (held_[i]) return false;
    const double reach = std::max(20.0 * size_, starts_.diagonal().norm());
    const bool is_high = position.y() > starts_.max().y() + reach && velocity(body).norm() > 0.1 * speed_;
    return (rises || is_high) && is_free(world, body);
}

// Whether a body of a standing scene is far from where it may be.
bool Measurements::strayed(std::size_t i, const Vector3& position) const {
    const double high = std::max(start_[i].y(), standing_->rest_heights[i]);
    const Vector3 nearest(start_[i].x(), std::clamp(position.y(), lowest_place(i), high), start_[i].z());
    return (position - nearest).norm() > 20.0 * size_;
}

Measurements::Moment Measurements::judge(const Simulation& simulation, double stretch) const {
    Moment moment{.max_speed = simulation.sample().max_speed,
                  .kinetic_energy = simulation.sample().kinetic_energy,
                  .tunnelled = passed_,
                  .tore = stretch > 0.5,
                  .positions = latest_};
    const engine::World& world = simulation.scene().world;
    for_movable(world.bodies, [&](const Body& body, std::size_t i) {
        const double turning = corners_[i] > 0.0 ? corners_[i] * angular_velocity(body).norm() : 0.0;
        moment.fastest = std::max({moment.fastest, velocity(body).norm(), turning});
        moment.flew = moment.flew || flies(world, body, i);
        moment.tunnelled = moment.tunnelled || obstacles_.is_behind_plane(latest_[i]);
        moment.fell |= standing_ && latest_[i].y() < lowest_place(i) - 0.5 * size_;
    });
    return moment;
}

Outcome Measurements::outcome() const {
    const auto any = [this](bool Moment::*what) {
        return std::any_of(window_.begin() + 1, window_.end(), [what](const Moment& m) { return m.*what; });
    };
    if (window_.size() < 2) return Outcome::moving;  // nothing was simulated
    if (any(&Moment::flew)) return Outcome::fly;
    if (any(&Moment::tunnelled)) return Outcome::tunnel;
    if (any(&Moment::tore)) return Outcome::torn;
    if (any(&Moment::fell)) return Outcome::fall;

    const double speed = largest_last_second(&Moment::fastest);
    if (speed > 0.1 * speed_) return Outcome::moving;
    double displaced = 0.0;
    for (std::size_t i = 0; i < latest_.size(); ++i) {
        displaced = std::max(displaced, (latest_[i] - window_.front().positions[i]).norm());
    }
    if (displaced > 1e-5 * size_) return Outcome::creep;
    return speed > 1e-4 * speed_ ? Outcome::jitter : Outcome::rest;
}

double Measurements::largest_last_second(double Moment::*what) const {
    double largest = 0.0;
    for (std::size_t i = window_.size() > 1 ? 1 : 0; i < window_.size(); ++i) {
        largest = std::max(largest, window_[i].*what);
    }
    return largest;
}

std::vector<std::pair<std::string, std::optional<double>>> Measurements::of_scene() const {
    std::vector<std::pair<std::string, std::optional<double>>> measures;
    if (!scene_measure_) return measures;
    for (const auto& [name, value] : scene_measure_->result()) {
        measures.emplace_back(name, makes_scene_measure_ ? std::optional(value) : std::nullopt);
    }
    return measures;
}

std::vector<double> Measurements::heights() const {
    std::vector<double> heights;
    for (const Vector3& position : latest_) heights.push_back(position.y());
    return heights;
}

}  // namespace pushfactor::demos
