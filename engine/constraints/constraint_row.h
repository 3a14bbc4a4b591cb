// One row of the system, paper sections 5.1 and 6.1.2: the only thing that constraints and solvers share.
//
// Symbols: j_c axis of the row [1 for the linear, m for the angular part], v_ab velocities of both bodies
// [m/s, rad/s], v push factor [m/s], lambda force along the axis [N], c_min and c_max its bounds [N].
//
// Deviations: 6.1.2 calls J a 6n x c matrix; rows are constraints, so it is c x 6n, and a row holds only its
// two blocks of six. The table of symbols gives v_ab in m/s^2; it is in m/s.
#pragma once

#include "engine/base/math.h"
#include "engine/constraints/push_factor.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace pushfactor::engine {

enum class RowKind { contact, friction, distance };
inline constexpr std::size_t row_kind_count = 3;

// j_c in two parts, one a body (6.1.2). World frame.
struct Jacobian {
    Vector6 a = Vector6::Zero();
    Vector6 b = Vector6::Zero();
};

// Whether a row is bounded alone or together with the row next to it, which acts on the same two bodies and has the
// same bounds: the length of both lambdas is at most c_max (the round cone of Coulomb friction).
enum class Disc { none, first, second };

// What lambda is clamped to. With `of_row` below zero the numbers are forces in newton; otherwise they are
// factors [1] of the lambda of row `of_row` in the same column (Coulomb friction: -mu and mu of the normal row).
struct Bounds {
    double c_min = -std::numeric_limits<double>::infinity();
    double c_max = std::numeric_limits<double>::infinity();
    int of_row = -1;         // index into the rows of the step; must come before this row
    Disc disc = Disc::none;  // with one: c_min = -c_max
    bool in_momenta = true;  // false: lambda of the last of two columns is zero
};

// The answer for one row in both columns [N]: the first moves positions, the last sets momenta.
struct Lambda {
    double first = 0.0;
    double last = 0.0;
};

// What a row is called in outputs. Nothing is computed from it.
struct RowLabel {
    RowKind kind = RowKind::contact;
    int point = 0;     // contact point within its pair; 0 for other kinds
    double gap = 0.0;  // m, below zero is penetration; for distances the length error, 0 for a loose rope
};

struct ConstraintRow {
    // Not defaulted: a vector would fill the whole row with zeros before its members get their values.
    ConstraintRow() {}  // NOLINT(modernize-use-equals-default)

    int body_a = 0;  // indices into the bodies of the world
    int body_b = 0;
    Jacobian jacobian;
    PushFactor push;
    // c of the constraint where the step begins [m], for who follows a row that acts one way through the step: a
    // gap above zero, a loose rope below; an overlap the other way round.
    double error = 0.0;
    Bounds bounds;
    Lambda guess;  // where an iterative solver starts (6.2.3); zero when nothing is cached
    RowLabel label;
};

}  // namespace pushfactor::engine
