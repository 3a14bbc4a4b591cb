// Four contacts with round friction that share no body, solved at once in small steps (small_steps.h): all that
// they need of a contact stands here, once, in the four lanes of vectors. Every lane is computed in the order of
// solvers::sweep(), so that the bits are those of one contact after the other, on every instruction set. Internal
// to the step.
//
// Symbols as in solvers/unit_row.h: u, y, t, s; x velocity and d displacement of a body, six numbers each.
#pragma once

#include "engine/base/instruction_sets.h"
#include "engine/base/math.h"
#include "engine/step/aim.h"

#include <array>
#include <span>

namespace pushfactor::engine {

// On cache lines of its own, and so on the boundaries that AVX wants.
struct alignas(64) FourContacts {
    static constexpr std::size_t count = 4;
    enum : int {
        rows = 3,  // the normal and both tangents
        none = -1  // a static body, or no contact
    };
    using Lanes = Four;
    using Mask = decltype(Lanes() < Lanes());
    using Of = std::array<int, count>;

    // By row, and for axes by number of x: those of a, then those of b.
    Lanes axis[rows][12];
    Lanes coupling[rows];  // as UnitRows::Block::couplings
    Lanes y[rows], t[rows], scale[rows];
    Lanes radius;                        // of the disc, in units of the normal's y
    Lanes keeps;                         // of the normal
    Lanes change;                        // m/s, the largest of a contact's rows in the last pass
    Lanes pushing[rows], lasting[rows];  // N s, sums of y / s over all solves with and without the push
    // Of the normal: error at the start of the step, and now [m]; velocity of moved bodies [m/s]; share of the
    // error that a step corrects, and the speed of its correction [m/s].
    Lanes start, error, carried, beta, correcting;
    Mask holds;  // whether it has these; else aim() leaves its target as it is
    Mask acts;   // whether a contact takes part in a sweep

    Of row;   // of the step, of the normal
    Of a, b;  // bodies, by their numbers in the island
};

// The targets of the normals, and keeps.
void aim(std::span<FourContacts> some, const Aim& aim, std::span<const Vector6> d);
// As solvers::sweep().
void sweep(std::span<FourContacts> some, std::span<Vector6> x);
// Adds the forces of a solve to its sums.
void add_up(std::span<FourContacts> some, bool pushes);
// Adds u y of all rows to the velocities of the bodies.
void push(std::span<FourContacts> some, std::span<Vector6> x);
// Writes the natural-map residuals to `change`.
void look(std::span<FourContacts> some, std::span<Vector6> x);
// The targets of the normals of a displacement, whose y are zero at first.
void aim_apart(std::span<FourContacts> some, const Apart& apart, std::span<const Vector6> d);
// One sweep over the normals that hold a place.
void push_apart(std::span<FourContacts> some, std::span<Vector6> d);

}  // namespace pushfactor::engine
