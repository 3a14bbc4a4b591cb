// Random rows with bounds between random bodies: problems that no scene makes, in which rows may be clamped,
// redundant or inconsistent. A solution is checked only against its definition.
#pragma once

#include "tests/engine/rows.h"
#include "tests/random.h"

#include <cmath>
#include <cstdint>

namespace pushfactor::tests {

// `bodies` movable ones with masses from 10^-decades to 10^decades kg, body 0 static; about `rows` rows, a third of
// them doubled. All bounds are finite: inconsistent rows then have a solution, too.
inline Frozen random_rows(std::uint64_t seed, int bodies, int rows, double decades) {
    Random random(seed);
    std::vector<engine::Body> all{engine::static_body(engine::Vector3::Zero())};
    for (int i = 0; i < bodies; ++i) {
        const double mass = std::pow(10.0, random.in(-decades, decades));
        const double width = random.in(0.2, 2);
        const double depth = random.in(0.2, 2);
        const engine::Vector3 position = random.vector(-3, 3);
        all.push_back(engine::box_body(mass, {width, 1, depth}, position, random.rotation()));
        all.back().force = random.vector(-20, 20);
        all.back().torque = random.vector(-5, 5);
    }
    std::vector<engine::ConstraintRow> made;
    while (static_cast<int>(made.size()) < rows) {
        engine::ConstraintRow row;
        row.body_a = static_cast<int>(random.in(0, bodies + 1));
        row.body_b = static_cast<int>(random.in(0, bodies + 1));
        if (row.body_a == row.body_b) continue;
        row.jacobian.a.head<3>() = random.vector(-1, 1);
        row.jacobian.a.tail<3>() = random.vector(-1, 1);
        row.jacobian.b.head<3>() = random.vector(-1, 1);
        row.jacobian.b.tail<3>() = random.vector(-1, 1);
        row.push.lasting = random.in(-0.1, 0.1);
        const double kind = random.in(0, 1);
        row.bounds.c_min = kind < 0.5 ? 0.0 : kind < 0.7 ? -random.in(0, 20) : -1e4;
        row.bounds.c_max = kind < 0.2 || kind > 0.9 ? random.in(0.1, 30) : 1e4;
        if (random.in(0, 1) < 0.3) row.push.correcting = random.in(0, 0.5);
        made.push_back(row);
        if (random.in(0, 1) < 0.3) made.push_back(row);
    }
    return {all, made, 1.0 / 60.0};
}

}  // namespace pushfactor::tests
