// Worlds of a few bodies with contacts as the default preset has them, for tests of fast and extreme bodies.
#pragma once

#include "engine/bodies/diagnostics.h"
#include "engine/constraints/contact_constraints.h"
#include "engine/forces/gravity.h"
#include "engine/impacts/impacts.h"
#include "engine/measures/penetration.h"
#include "engine/world.h"

#include <memory>
#include <vector>

namespace pushfactor::tests {

struct Surface {
    double friction = 0.5;
    double restitution = 0.0;
};

// Measures of some steps.
struct Seen {
    double penetration = 0.0;   // m, the deepest
    double upward_speed = 0.0;  // m/s, the largest of the last body
    double speed_at_end = 0.0;  // m/s, the largest of all bodies in the last sixth of the steps
    double lowest = 1e300;      // m, centre of the last body
};

struct ContactScene {
    engine::World world;
    std::vector<engine::collision::Collider> colliders;

    ContactScene() { world.rotate = engine::rotate_by_small_turns; }

    static constexpr double dt = 1.0 / 60.0;

    // Returns the body, valid until the next one is added.
    engine::Body& add(const engine::Body& body, const engine::collision::Shape& shape,
                      const Surface& surface = {}) {
        world.bodies.push_back(body);
        colliders.push_back({.body = static_cast<int>(world.bodies.size()) - 1,
                             .shape = shape,
                             .friction = surface.friction,
                             .restitution = surface.restitution});
        return world.bodies.back();
    }

    engine::Body& add_ball(double radius, const engine::Vector3& position,
                           const engine::Vector3& velocity = {0, 0, 0}, const Surface& surface = {}) {
        engine::Body& body =
            add(engine::ball_body(1.0, radius, position), engine::collision::Sphere{radius}, surface);
        body.linear_momentum = velocity;
        return body;
    }

    engine::Body& add_box(const engine::Vector3& size, const engine::Vector3& position,
                          const engine::Vector3& velocity = {0, 0, 0}, const Surface& surface = {}) {
        engine::Body& body =
            add(engine::box_body(1.0, size, position), engine::collision::Box{0.5 * size}, surface);
        body.linear_momentum = velocity;
        return body;
    }

    engine::Body& add_ground(const Surface& surface = {}) {
        return add(engine::static_body(engine::Vector3::Zero()), engine::collision::Plane{}, surface);
    }

    engine::Body& add_plate(const engine::Vector3& size, const engine::Vector3& position = {0, 0, 0},
                            const Surface& surface = {}) {
        return add(engine::static_body(position), engine::collision::Box{0.5 * size}, surface);
    }

    // The touches of a step of the scene as it is, before it is solved. Valid until the next call.
    const std::vector<engine::collision::Touch>& touches(const engine::collision::Detection& detection = {
                                                             .margin = 0.01, .permitted = 0.0022}) {
        before_.clear();
        after_.clear();
        paths_.clear();
        for (const engine::Body& body : world.bodies) {
            before_.push_back(motion_of(body));
            after_.push_back(motion_of(body, dt));
            paths_.push_back(motion_in_step(body, dt, world.rotate));
        }
        const engine::StepMotions motions{dt, before_, after_, paths_};
        return detector_.detect(colliders, world.bodies, detection, &motions);
    }

    // Six plates, 6 m apart.
    void add_closed_box(const Surface& surface = {}) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const double side : {-3.1, 3.1}) {
                engine::Vector3 size = engine::Vector3::Constant(6.4);
                size[axis] = 0.2;
                add_plate(size, side * engine::Vector3::Unit(axis), surface);
            }
        }
    }

    // Puts the parts together, after the last body.
    void build(const engine::Vector3& gravity = {0, -10, 0}, const engine::Correction& correction = {}) {
        if (!gravity.isZero(0.0)) world.forces.push_back(std::make_unique<engine::Gravity>(gravity));
        auto stage = std::make_unique<engine::ContactConstraints>(
            colliders,
            engine::ContactChoices{.correction = correction, .slop = 0.002, .detection = {.margin = 0.01}});
        const auto any = [this](double engine::collision::Collider::*what) {
            for (const auto& collider : colliders) {
                if (collider.*what > 0.0) return true;
            }
            return false;
        };
        using engine::collision::Collider;
        if (any(&Collider::friction)) stage->set_friction(engine::cone_friction);
        if (any(&Collider::restitution)) world.impacts = std::make_unique<engine::Impacts>(*stage);
        stage->set_continuous_collision(std::make_unique<engine::collision::ContinuousCollision>());
        stage->set_cache(std::make_unique<engine::ContactCache>());
        world.constraints.push_back(std::move(stage));
        world.solver = engine::solvers::make_solver("auto");
        world.termination = {.iterations = 25, .tolerance_high = 1e-8, .tolerance_low = 1e-10};
    }

    double penetration() const { return engine::penetration(world.bodies, colliders).max; }

    Seen watch(int steps, double step = dt) {
        Seen seen;
        for (int n = 1; n <= steps; ++n) {
            world.step(step);
            seen.penetration = std::max(seen.penetration, penetration());
            seen.upward_speed = std::max(seen.upward_speed, velocity(world.bodies.back()).y());
            seen.lowest = std::min(seen.lowest, world.bodies.back().position.y());
            if (6 * n > 5 * steps) seen.speed_at_end = std::max(seen.speed_at_end, max_speed(world.bodies));
        }
        return seen;
    }

  private:
    engine::collision::Detector detector_;
    std::vector<engine::Motion> before_, after_, paths_;
};

}  // namespace pushfactor::tests
