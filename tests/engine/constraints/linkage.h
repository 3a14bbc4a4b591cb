// Bodies on joints, for tests.
#pragma once

#include "engine/bodies/diagnostics.h"
#include "engine/constraints/joint_constraints.h"
#include "engine/energy_account.h"
#include "engine/forces/gravity.h"
#include "engine/world.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace pushfactor::tests {

using namespace engine;

using std::numbers::pi;
inline const Vector3 gravity(0, -10, 0);
inline constexpr Correction whole{PushKind::persistent, 1.0};

inline Quaternion about_z(double angle) {
    return Quaternion(Eigen::AngleAxisd(angle, Vector3::UnitZ()));
}

// Bodies on joints; body 0 is the world.
struct Linkage {
    World world;
    std::vector<Joint> joints;
    const JointConstraints* source = nullptr;
    EnergyAccount account{gravity};

    Linkage() { world.bodies.push_back(static_body(Vector3::Zero())); }

    int add(const Body& body) {
        world.bodies.push_back(body);
        return static_cast<int>(world.bodies.size()) - 1;
    }

    // Joins a and b at a point of the world, as they are now; the axis is z.
    Joint& join(int a, int b, const Vector3& at, bool hinge = true) {
        const auto in = [&](int body) -> Vector3 {
            const Body& own = world.bodies[static_cast<std::size_t>(body)];
            return own.orientation.conjugate() * (at - own.position);
        };
        Joint& joint = joints.emplace_back();
        joint = {.body_a = a, .body_b = b, .point_a = in(a), .point_b = in(b)};
        if (!hinge) return joint;
        const Quaternion& q_a = world.bodies[static_cast<std::size_t>(a)].orientation;
        joint.hinge = Hinge{.axis = q_a.conjugate() * Vector3::UnitZ(),
                            .zero = q_a.conjugate() * world.bodies[static_cast<std::size_t>(b)].orientation};
        return joint;
    }

    void build(const Correction& correction = whole, bool heavy = true, const char* solver = "direct") {
        auto made = std::make_unique<JointConstraints>(joints, correction, true);
        source = made.get();
        world.constraints.push_back(std::move(made));
        if (heavy) world.forces.push_back(std::make_unique<Gravity>(gravity));
        if (!heavy) account = EnergyAccount(Vector3::Zero());
        world.solver = solvers::make_solver(solver);
        world.termination = {.iterations = 1000, .tolerance_high = 1e-12, .tolerance_low = 1e-12};
    }

    StepCount step(double dt) {
        account.begin(world.bodies);
        const StepCount count = world.step(dt);
        account.end(world, dt);
        return count;
    }

    double angle(std::size_t joint = 0) const { return angle_of(source->joints()[joint], world.bodies); }
    double speed(std::size_t body) const { return angular_velocity(world.bodies[body]).z(); }
    double energy() const { return kinetic_energy(world.bodies) + potential_energy(world.bodies, gravity); }

    // How far the points of the joints are apart [m], and by how much their axes differ [rad].
    double opened() const {
        double largest = 0.0;
        for (const Joint& joint : source->joints()) {
            const auto [from, to] = span_of(joint, world.bodies);
            largest = std::max(largest, (to - from).norm());
        }
        return largest;
    }
    double tilted() const {
        double largest = 0.0;
        for (const Joint& joint : source->joints()) {
            const Body& a = world.bodies[static_cast<std::size_t>(joint.body_a)];
            const Body& b = world.bodies[static_cast<std::size_t>(joint.body_b)];
            const Vector3 axis = joint.hinge->axis;
            const Vector3 of_b = b.orientation * (joint.hinge->zero.conjugate() * axis);
            largest = std::max(largest, (a.orientation * axis).cross(of_b).norm());
        }
        return largest;
    }
};

// A bar of 1 m, 0.2 m, 0.1 m and 1 kg that hangs by its end at the origin, at `angle` from straight down.
inline constexpr double bar_mass = 1.0, arm = 0.5;
inline const Vector3 bar_size(0.2, 1.0, 0.1);

inline Body bar_at(double angle) {
    return box_body(bar_mass, bar_size, about_z(angle) * Vector3(0, -arm, 0), about_z(angle));
}

// About the hinge, kg m^2.
inline const double bar_moment = bar_mass * ((0.04 + 1.0) / 12.0 + arm * arm);

inline Linkage pendulum(double angle) {
    Linkage linkage;
    linkage.add(bar_at(0.0));
    linkage.join(0, 1, Vector3::Zero());
    linkage.world.bodies[1] = bar_at(angle);
    return linkage;
}

}  // namespace pushfactor::tests
