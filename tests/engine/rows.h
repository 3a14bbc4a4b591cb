// Systems built by hand for tests of rows and solvers.
#pragma once

#include "engine/system/system_equation.h"
#include "engine/world.h"

#include <vector>

namespace pushfactor::tests {

// `count` equal balls of 1 kg on the ground, one on the other, gravity 10, only vertical contact rows.
struct Column {
    std::vector<engine::Body> bodies;
    std::vector<engine::ConstraintRow> rows;

    explicit Column(int count) {
        bodies.push_back(engine::static_body(engine::Vector3::Zero()));
        for (int i = 1; i <= count; ++i) {
            engine::Body body = engine::box_body(1.0, engine::Vector3::Ones(), {0, i - 0.5, 0});
            body.force = engine::Vector3(0, -10, 0);
            bodies.push_back(body);

            engine::ConstraintRow row;
            row.body_a = i - 1;
            row.body_b = i;
            if (i > 1) row.jacobian.a[1] = -1.0;
            row.jacobian.b[1] = 1.0;
            row.bounds.c_min = 0.0;
            rows.push_back(row);
        }
    }
};

// The rows that `source`, an object or a temporary, appends in a step.
template <typename Source>
std::vector<engine::ConstraintRow> rows_of(Source&& source, const engine::StepStart& step) {
    engine::RowList rows;
    source.append_rows(step, rows);
    return {rows.begin(), rows.end()};
}

// A copy of the rows of `world` with zero guesses, and their system.
struct Frozen {
    std::vector<engine::ConstraintRow> rows;
    engine::SystemEquation system;

    Frozen(std::span<const engine::Body> bodies, std::span<const engine::ConstraintRow> source, double dt)
        : rows(source.begin(), source.end()) {
        build_system(bodies, rows, dt, system);
    }
    engine::Columns zero() const { return engine::Columns::Zero(system.row_count(), system.column_count()); }
};

}  // namespace pushfactor::tests
