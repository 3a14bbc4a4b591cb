// Random contacts between random bodies: problems that have a solution at any mass, redundancy or width of bounds.
#pragma once

#include "tests/engine/rows.h"
#include "tests/random.h"

#include <cmath>
#include <cstdint>
#include <utility>

namespace pushfactor::tests {

enum class RandomFriction { box, coulomb, cone };

// 2 to 100 bodies with masses from 10^-decades to 10^decades kg, body 0 static. Each leans on one of the six before
// it and touches some of the nearby ones, at one to four points of a plane (four are redundant), with normal and
// two tangents; a tenth of the pairs are joined by a bar instead. The bounds of the tangents are forces in
// proportion to the weight or, in a third of the pairs, narrower than rounding; or all are Coulomb friction, each
// tangent separately or both on a disc. The rows ask for less than some motion of the bodies gives them, so that
// they are consistent.
inline Frozen random_contacts(std::uint64_t seed, RandomFriction friction, double decades) {
    using namespace engine;
    Random random(seed);
    const double dt = 1.0 / 60.0;
    const int count = 2 + static_cast<int>(98.0 * std::pow(random.in(0, 1), 2));
    std::vector<Body> bodies{static_body(Vector3::Zero())};
    std::vector<std::pair<Vector3, Vector3>> motion{{Vector3::Zero(), Vector3::Zero()}};  // that the rows allow
    std::vector<int> leans_on{0};
    for (int i = 0; i < count; ++i) {
        const double mass = std::pow(10.0, random.in(-decades, decades));
        const Vector3 size(random.in(0.3, 1), random.in(0.3, 1), random.in(0.3, 1));
        leans_on.push_back(std::max(0, static_cast<int>(bodies.size()) - 1 - static_cast<int>(random.in(0, 6))));
        const Vector3 beside = bodies[static_cast<std::size_t>(leans_on.back())].position;
        const Vector3 away = random.in(0.4, 0.8) * (random.rotation() * Vector3::UnitY());
        bodies.push_back(box_body(mass, size, beside + away, random.rotation()));
        bodies.back().force = Vector3(0, -10 * mass, 0);
        bodies.back().linear_momentum = mass * random.vector(-0.5, 0.5);
        motion.emplace_back(random.vector(-0.2, 0.2), random.vector(-0.2, 0.2));
    }
    std::vector<ConstraintRow> rows;
    const auto add = [&](int a, int b, const Vector3& point, const Vector3& axis) -> ConstraintRow& {
        ConstraintRow& row = rows.emplace_back();
        row.body_a = a;
        row.body_b = b;
        const auto at = [&](int body) { return point - bodies[static_cast<std::size_t>(body)].position; };
        if (a > 0) row.jacobian.a = stacked(-axis, -at(a).cross(axis));
        if (b > 0) row.jacobian.b = stacked(axis, at(b).cross(axis));
        return row;
    };
    const auto speed = [&](const ConstraintRow& row) {
        const auto of = [&](int body, const Vector6& axis) {
            const auto& [v, w] = motion[static_cast<std::size_t>(body)];
            return axis.head<3>().dot(v) + axis.tail<3>().dot(w);
        };
        return of(row.body_a, row.jacobian.a) + of(row.body_b, row.jacobian.b);
    };
    const auto lighter = [&](int a, int b) {
        const double mass = bodies[static_cast<std::size_t>(b)].mass();
        return a > 0 ? std::min(mass, bodies[static_cast<std::size_t>(a)].mass()) : mass;
    };
    for (int b = 1; b <= count; ++b) {
        const Vector3 place = bodies[static_cast<std::size_t>(b)].position;
        for (int a = 0; a < b; ++a) {
            const Vector3 apart = place - bodies[static_cast<std::size_t>(a)].position;
            if (a != leans_on[static_cast<std::size_t>(b)] && (apart.norm() > 0.9 || random.in(0, 1) < 0.3))
                continue;
            const Vector3 normal = (apart.normalized() + random.vector(-0.3, 0.3)).normalized();
            const Vector3 first = normal.unitOrthogonal(), second = normal.cross(first);
            const Vector3 middle = place - 0.5 * apart;
            if (random.in(0, 1) < 0.1) {
                ConstraintRow& bar = add(a, b, middle, normal);
                bar.push.lasting = speed(bar);
                continue;
            }
            const int points = static_cast<int>(random.in(1, 5));
            const bool thin = random.in(0, 1) < 1.0 / 3.0;
            for (int p = 0; p < points; ++p) {
                const Vector3 point =
                    middle + (p % 2 == 0 ? 0.2 : -0.2) * first + (p / 2 == 0 ? 0.2 : -0.2) * second;
                ConstraintRow& row = add(a, b, point, normal);
                row.bounds.c_min = 0.0;
                row.push.lasting = speed(row) - random.in(0, 1) * random.in(0, 0.5);
                const int normal_row = static_cast<int>(rows.size()) - 1;
                for (const bool is_first : {true, false}) {
                    const Vector3& tangent = is_first ? first : second;
                    ConstraintRow& slides = add(a, b, point, tangent);
                    const double weight = 10.0 * lighter(a, b);
                    const double bound = thin ? 1e-19 : random.in(0, 0.5) * weight;
                    slides.bounds = {.c_min = -bound, .c_max = bound};
                    if (friction == RandomFriction::box) continue;
                    const double mu = thin ? 0.7 : 0.3;
                    slides.bounds = {.c_min = -mu, .c_max = mu, .of_row = normal_row};
                    if (friction == RandomFriction::cone) {
                        slides.bounds.disc = is_first ? Disc::first : Disc::second;
                    }
                }
            }
        }
    }
    return {bodies, rows, dt};
}

}  // namespace pushfactor::tests
