// The system as section 6.1 of the paper writes it: whole matrices and vectors, every product by its definition.
// For tests of the paper's algebra.
//
// Symbols: J all rows as one c x 6n matrix (6.1.2), M^-1 system inverse mass, v_1 and v_2 system velocities before
// and after the step, f_ext external forces, v push factors, lambda, A and b of 6.2.9; dt time step. SI units.
#pragma once

#include "engine/bodies/body.h"
#include "engine/constraints/distance_constraints.h"

#include <span>
#include <vector>

namespace pushfactor::tests {

struct Whole {
    static constexpr double dt = 1.0 / 60.0;  // s

    engine::MatrixX J, inverse_mass;
    engine::VectorX v1, f_ext, push;

    Whole(std::span<const engine::Body> bodies, std::span<const engine::ConstraintRow> rows);

    engine::MatrixX A() const;
    engine::VectorX b() const;
    engine::VectorX v2(const engine::VectorX& lambda) const;  // 12.3.1
};

// Boxes that tumble, each held to the next by a bar between random points of both.
struct HangingBoxes {
    std::vector<engine::Body> bodies;
    std::vector<engine::ConstraintRow> rows;

    HangingBoxes(int count, const engine::Correction& correction, std::uint64_t seed);
};

}  // namespace pushfactor::tests
