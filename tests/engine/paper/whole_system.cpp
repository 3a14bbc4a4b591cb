#include "tests/engine/paper/whole_system.h"

#include "tests/dense_algebra.h"
#include "tests/engine/rows.h"
#include "tests/random.h"

namespace pushfactor::tests {

using namespace engine;

namespace {

template <class Things>
Eigen::Index length(const Things& things) {
    return static_cast<Eigen::Index>(things.size());
}

Body tumbling_box(Random& random, const Vector3& about) {
    const double mass = random.in(0.5, 3);
    const Vector3 size = random.vector(0.4, 2), position = about + random.vector(-0.5, 0.5);
    Body body = box_body(mass, size, position, random.rotation());
    body.linear_momentum = random.vector(-3, 3);
    body.angular_momentum = random.vector(-3, 3);
    body.force = random.vector(-20, 20);
    body.torque = random.vector(-5, 5);
    return body;
}

}  // namespace

Whole::Whole(std::span<const Body> bodies, std::span<const ConstraintRow> rows)
    : J(MatrixX::Zero(length(rows), 6 * length(bodies))),
      inverse_mass(MatrixX::Zero(6 * length(bodies), 6 * length(bodies))),
      v1(6 * length(bodies)),
      f_ext(6 * length(bodies)),
      push(length(rows)) {
    Eigen::Index i = 0;
    for (const Body& body : bodies) {
        inverse_mass.block<3, 3>(i, i) = body.inverse_mass * Matrix3::Identity();
        inverse_mass.block<3, 3>(i + 3, i + 3) = world_inverse_inertia(body);
        v1.segment<6>(i) = stacked(velocity(body), angular_velocity(body));
        f_ext.segment<6>(i) = stacked(body.force, body.torque);
        i += 6;
    }
    Eigen::Index j = 0;
    for (const ConstraintRow& row : rows) {
        J.block<1, 6>(j, 6 * row.body_a) += row.jacobian.a.transpose();
        J.block<1, 6>(j, 6 * row.body_b) += row.jacobian.b.transpose();
        push[j++] = row.push.lasting;
    }
}

MatrixX Whole::A() const {
    return product(product(J, inverse_mass), J.transpose());
}

VectorX Whole::b() const {
    return push / dt - J * (v1 / dt + inverse_mass * f_ext);
}

VectorX Whole::v2(const VectorX& lambda) const {
    return dt * inverse_mass * (J.transpose() * lambda + f_ext) + v1;
}

HangingBoxes::HangingBoxes(int count, const Correction& correction, std::uint64_t seed) {
    Random random(seed);
    std::vector<Distance> bars;
    for (int i = 0; i < count; ++i) {
        bodies.push_back(tumbling_box(random, Vector3(2.0 * i, 0, 0)));
        if (i == 0) continue;
        bars.push_back({.body_a = i - 1, .body_b = i, .length = 1.5});
        bars.back().point_a = random.vector(-0.4, 0.4);
        bars.back().point_b = random.vector(-0.4, 0.4);
    }
    rows = rows_of(DistanceConstraints(bars, correction, false), {bodies, Whole::dt});
}

}  // namespace pushfactor::tests
