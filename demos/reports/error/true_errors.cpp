#include "demos/reports/error/true_errors.h"

#include "demos/reports/error/converged_forces.h"
#include "demos/runs/measurements.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::demos::reports::error {

namespace {

using engine::Body;
using engine::Vector3;

double engine_dt(const Settings& settings) {
    return settings.dt.value() / settings.substeps.value_or(1);
}

double sideways(const Vector3& from, const Vector3& to) {
    return std::hypot(to.x() - from.x(), to.z() - from.z());
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

// Stacks: the first body is the ground, the cubes follow from below.
class RestError : public TrueError {
  public:
    explicit RestError(const Simulation& start) : standing_(start.scene().standing.value()) {
        for (const Body& body : start.scene().world.bodies) {
            if (body.is_static()) continue;
            starts_.push_back(body.position);
            weight_ += body.mass() * start.scene().gravity.norm();
        }
    }

    void observe(const Simulation& simulation) override {
        const engine::World& world = simulation.scene().world;
        const bool last_second = simulation.sample().time > simulation.settings().seconds - 1.0;
        for (std::size_t i = 0; i < starts_.size(); ++i) {
            const Vector3& position = world.bodies[i + 1].position;
            sideways_ = std::max(sideways_, sideways(starts_[i], position));
            const Vector3 rest(starts_[i].x(), standing_.rest_heights[i], starts_[i].z());
            if (last_second) distance_.add((position - rest).squaredNorm());
        }
        if (last_second) force_.add(std::pow(bottom_force(world) / weight_ - 1.0, 2));
    }

    std::vector<NamedError> result() const override {
        return {{"rest_position_rms_m", distance_.value()},
                {"max_sideways_m", sideways_},
                {"bottom_force_rms", force_.value()}};
    }

  private:
    Standing standing_;
    std::vector<Vector3> starts_;
    double weight_ = 0.0;  // N, of all cubes
    double sideways_ = 0.0;
    Rms distance_, force_;
};

class PartingError : public TrueError {
  public:
    explicit PartingError(const Simulation& start) {
        const Settings& settings = start.settings();
        const auto& bodies = start.scene().world.bodies;
        for (std::size_t i = 1; i < bodies.size(); ++i) {
            starts_.push_back(bodies[i].position);
            cubes_.push_back({.start = bodies[i].position.y(),
                              .rest = start.scene().standing.value().rest_heights[i - 1],
                              .push = settings.contacts,
                              .dt = engine_dt(settings),
                              .gravity = start.scene().gravity.norm()});
        }
    }

    void observe(const Simulation& simulation) override {
        const long steps = simulation.sample().step * simulation.settings().substeps.value_or(1);
        for (std::size_t i = 0; i < cubes_.size(); ++i) {
            const Body& body = simulation.scene().world.bodies[i + 1];
            const Vector3 exact(starts_[i].x(), cubes_[i].height(steps), starts_[i].z());
            distance_.add((body.position - exact).squaredNorm());
            speed_ = std::max(speed_, std::abs(velocity(body).y() - cubes_[i].upward_speed(steps)));
        }
    }

    std::vector<NamedError> result() const override {
        return {{"position_rms_m", distance_.value()}, {"max_upward_speed_m_per_s", speed_}};
    }

  private:
    std::vector<PartingCube> cubes_;
    std::vector<Vector3> starts_;
    Rms distance_;
    double speed_ = 0.0;
};

class SceneError : public TrueError {
  public:
    explicit SceneError(const Simulation& start) : measure_(start.scene().measure(start.scene().world)) {}
    void observe(const Simulation& simulation) override { measure_->observe(simulation.scene().world); }

    std::vector<NamedError> result() const override {
        std::vector<NamedError> errors;
        for (const auto& [name, value] : measure_->result()) errors.push_back({name, std::abs(value)});
        return errors;
    }

  private:
    std::unique_ptr<SceneMeasure> measure_;
};

class ColumnError : public TrueError {
  public:
    void observe(const Simulation& simulation) override {
        if (simulation.sample().step != 1) return;
        const engine::World& world = simulation.scene().world;
        const int count = static_cast<int>(world.bodies.size()) - 1;
        engine::Columns exact = engine::Columns::Zero(world.lambda().rows(), world.lambda().cols());
        for (Eigen::Index j = 0; j < exact.rows(); ++j) {
            const engine::ConstraintRow& row = world.rows()[static_cast<std::size_t>(j)];
            if (row.label.kind != engine::RowKind::contact) continue;
            exact.row(j).setConstant(weight_above(std::min(row.body_a, row.body_b), count,
                                                  world.bodies.back().mass(), simulation.scene().gravity.norm()));
        }
        error_ = force_error(world.system(), world.lambda(), exact).value_or(0.0);
    }

    std::vector<NamedError> result() const override { return {{"force_error_first_step", error_}}; }

  private:
    double error_ = 0.0;
};

class ConvergedError : public TrueError {
  public:
    explicit ConvergedError(const Simulation& start) : every_(std::max(1L, whole_steps(start.settings()) / 30)) {}

    void observe(const Simulation& simulation) override {
        if (simulation.sample().step % every_ != 0) return;
        const engine::World& world = simulation.scene().world;
        if (world.rows().empty()) return;
        residuals_.push_back(simulation.sample().residual);
        const auto converged = solver_.solve(world.system(), world.lambda());
        if (!converged) {
            ++missed_;
            return;
        }
        if (const auto error = force_error(world.system(), world.lambda(), *converged)) errors_.push_back(*error);
    }

    std::vector<NamedError> result() const override {
        return {{"force_error_median", median(errors_)},
                {"residual_median_m_per_s", median(residuals_)},
                {"moments_without_reference", static_cast<double>(missed_)}};
    }

  private:
    long every_;
    ConvergedSolver solver_;
    std::vector<double> errors_, residuals_;
    long missed_ = 0;
};

class StandingError : public TrueError {
  public:
    explicit StandingError(const Simulation& start)
        : start_(start.scene().world.bodies), from_(start.settings().seconds - 1.0) {}

    void observe(const Simulation& simulation) override {
        if (simulation.sample().time <= from_) return;
        const std::vector<Body>& bodies = simulation.scene().world.bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (!bodies[i].is_static()) moved_.add((bodies[i].position - start_[i].position).squaredNorm());
        }
    }

    std::vector<NamedError> result() const override { return {{"moved_rms_m", moved_.value()}}; }

  private:
    std::vector<Body> start_;
    double from_ = 0.0;  // s
    Rms moved_;
};

class OverlapError : public TrueError {
  public:
    void observe(const Simulation& simulation) override { depths_.push_back(simulation.sample().penetration.max); }

    std::vector<NamedError> result() const override {
        return {{"deepest_overlap_median_m", median(depths_)},
                {"deepest_overlap_m", *std::max_element(depths_.begin(), depths_.end())}};
    }

  private:
    std::vector<double> depths_;
};

}  // namespace

double PartingCube::height(long steps) const {
    const auto n = static_cast<double>(steps);
    switch (push.kind) {
        case engine::PushKind::persistent:
            return start + push.beta * (rest - start) * n - gravity * dt * dt * n * (n - 1.0) / 2.0;
        case engine::PushKind::single_frame:
        case engine::PushKind::curve:
            return rest - (rest - start) * std::pow(1.0 - push.beta, n);
        case engine::PushKind::none:
            break;
    }
    return start;
}

double PartingCube::upward_speed(long steps) const {
    if (push.kind != engine::PushKind::persistent) return 0.0;
    return push.beta * (rest - start) / dt - gravity * dt * static_cast<double>(steps - 1);
}

double weight_above(int lower, int count, double mass, double gravity) {
    return (count - lower) * mass * gravity;
}

std::unique_ptr<TrueError> rest_error(const Simulation& start) {
    return std::make_unique<RestError>(start);
}

std::unique_ptr<TrueError> standing_error(const Simulation& start) {
    return std::make_unique<StandingError>(start);
}

std::unique_ptr<TrueError> parting_error(const Simulation& start) {
    return std::make_unique<PartingError>(start);
}

std::unique_ptr<TrueError> scene_error(const Simulation& start) {
    return std::make_unique<SceneError>(start);
}

std::unique_ptr<TrueError> overlap_error(const Simulation&) {
    return std::make_unique<OverlapError>();
}

std::unique_ptr<TrueError> column_error(const Simulation&) {
    return std::make_unique<ColumnError>();
}

std::unique_ptr<TrueError> converged_error(const Simulation& start) {
    return std::make_unique<ConvergedError>(start);
}

}  // namespace pushfactor::demos::reports::error
