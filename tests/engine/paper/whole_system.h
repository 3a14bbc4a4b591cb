// The system as section 6.1 of the paper writes it: whole matrices and vectors, every product by its definition.
// For tests of the paper's algebra.
//
// Symbols: J all rows as one c x 6n matrix (6.1.2), M^-1 system inverse mass, v_1 and v_2 system velocities before
// and after the step, f_ext external forces, v push factors, lambda, A and b of 6.2.9; dt time step. SI units.
#pragma once

#include "engine/constraints/distance_constraints.h"
#include "tests/engine/rows.h"
#include "tests/random.h"

#include <span>
#include <vector>

namespace pushfactor::tests {

struct Whole {
    static constexpr double dt = 1.0 / 60.0;  // s

    engine::MatrixX J, inverse_mass;
    engine::VectorX v1, f_ext, push;

    Whole(std::span<const engine::Body> bodies, std::span<const engine::ConstraintRow> rows)
        : J(engine::MatrixX::Zero(length(rows), 6 * length(bodies))),
          inverse_mass(engine::MatrixX::Zero(6 * length(bodies), 6 * length(bodies))),
          v1(6 * length(bodies)),
          f_ext(6 * length(bodies)),
          push(length(rows)) {
        Eigen::Index i = 0;
        for (const engine::Body& body : bodies) {
            inverse_mass.block<3, 3>(i, i) = body.inverse_mass * engine::Matrix3::Identity();
            inverse_mass.block<3, 3>(i + 3, i + 3) = world_inverse_inertia(body);
            v1.segment<6>(i) = engine::stacked(velocity(body), angular_velocity(body));
            f_ext.segment<6>(i) = engine::stacked(body.force, body.torque);
            i += 6;
        }
        Eigen::Index j = 0;
        for (const engine::ConstraintRow& row : rows) {
            J.block<1, 6>(j, 6 * row.body_a) += row.jacobian.a.transpose();
            J.block<1, 6>(j, 6 * row.body_b) += row.jacobian.b.transpose();
            push[j++] = row.push.lasting;
        }
    }

    engine::MatrixX A() const { return J * inverse_mass * J.transpose(); }
    engine::VectorX b() const { return push / dt - J * (v1 / dt + inverse_mass * f_ext); }
    // 12.3.1
    engine::VectorX v2(const engine::VectorX& lambda) const {
        return dt * inverse_mass * (J.transpose() * lambda + f_ext) + v1;
    }

    template <class Things>
    static Eigen::Index length(const Things& things) {
        return static_cast<Eigen::Index>(things.size());
    }
};

// Boxes that tumble, each held to the next by a bar between random points of both.
struct HangingBoxes {
    std::vector<engine::Body> bodies;
    std::vector<engine::ConstraintRow> rows;

    HangingBoxes(int count, const engine::Correction& correction, std::uint64_t seed) {
        Random random(seed);
        std::vector<engine::Distance> bars;
        for (int i = 0; i < count; ++i) {
            bodies.push_back(tumbling_box(random, engine::Vector3(2.0 * i, 0, 0)));
            if (i == 0) continue;
            bars.push_back({.body_a = i - 1, .body_b = i, .length = 1.5});
            bars.back().point_a = random.vector(-0.4, 0.4);
            bars.back().point_b = random.vector(-0.4, 0.4);
        }
        rows = rows_of(engine::DistanceConstraints(bars, correction, false), {bodies, Whole::dt});
    }

    static engine::Body tumbling_box(Random& random, const engine::Vector3& about) {
        const double mass = random.in(0.5, 3);
        const engine::Vector3 size = random.vector(0.4, 2), position = about + random.vector(-0.5, 0.5);
        engine::Body body = engine::box_body(mass, size, position, random.rotation());
        body.linear_momentum = random.vector(-3, 3);
        body.angular_momentum = random.vector(-3, 3);
        body.force = random.vector(-20, 20);
        body.torque = random.vector(-5, 5);
        return body;
    }
};

}  // namespace pushfactor::tests
