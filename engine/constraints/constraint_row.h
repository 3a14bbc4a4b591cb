// One row of the system, paper sections 5.1 and 6.1.2: the only data shared by constraints and solvers.
//
// Symbols: j_c axis of the row [1 for the linear, m for the angular part], v_ab velocities of both bodies
// [m/s, rad/s], v push factor [m/s], lambda force along the axis [N], c_min and c_max its bounds [N].
//
// Deviations: 6.1.2 calls J a 6n x c matrix; rows are constraints, so it is c x 6n, and a row stores only its
// two blocks of six. The table of symbols gives v_ab in m/s^2; it is in m/s.
#pragma once

#include "engine/base/math.h"
#include "engine/constraints/push_factor.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pushfactor::engine {

struct Body;

// The first three are those of nearly all rows; the others have traits of their own (RowDigest).
enum class RowKind { contact, friction, distance, joint, motor, limit, spring };
inline constexpr std::size_t row_kind_count = 7;

// j_c in two parts, one per body (6.1.2). World frame.
struct Jacobian {
    Vector6 a = Vector6::Zero();
    Vector6 b = Vector6::Zero();
};

// Whether a row is bounded alone or together with the next row, which acts on the same two bodies with the same
// bounds: the norm of both lambdas is then at most c_max (the round cone of Coulomb friction).
enum class Disc : std::uint8_t { none, first, second };

// Bounds of lambda. With negative `of_row` the numbers are forces in newtons; otherwise they are factors [1] of
// lambda of row `of_row` in the same column (Coulomb friction: -mu and mu of the normal row).
struct Bounds {
    double c_min = -infinity;
    double c_max = infinity;
    int of_row = -1;         // index into the rows of the step; must precede this row
    Disc disc = Disc::none;  // if set, c_min = -c_max
    bool in_momenta = true;  // false: lambda is zero in the last of two columns
};

// Solution for one row in both columns [N]: the first moves positions, the last sets momenta.
struct Lambda {
    double first = 0.0;
    double last = 0.0;
};

// Description of a row, for outputs and for its traits.
struct RowLabel {
    RowKind kind = RowKind::contact;
    int point = 0;     // contact point within its pair, or index of the distance or the joint
    double gap = 0.0;  // m, negative is penetration; for distances the length error, 0 for a loose rope; for joints
                       // how far they are open, for limits what is left
};

struct ConstraintRow {
    // Not defaulted: a vector would zero-fill the whole row before its members are set.
    ConstraintRow() {}  // NOLINT(modernize-use-equals-default)

    int body_a = 0;  // indices into the bodies of the world
    int body_b = 0;
    Jacobian jacobian;
    PushFactor push;
    // c of the constraint at the start of the step [m], and how its source corrects it; null: the row holds no
    // place, and `push` is all that it wants. Small steps correct bit by bit what is left of the error. One-sided
    // rows have a positive error for a gap, a negative one for a loose rope; the other sign means violation.
    double error = 0.0;
    const Correction* correction = nullptr;
    // s, added to A_jj [1/kg, >= 0]: the row gives way to its force, and reaches v - dt s lambda. 0 is a rigid row.
    // Springs, and what closes a loop.
    double softness = 0.0;
    Bounds bounds;
    Lambda guess;  // warm start of iterative solvers (6.2.3); zero if nothing is cached
    RowLabel label;
};

// Whether the row keeps bodies apart or points together, and its source says how errors are corrected.
inline bool holds_a_place(const ConstraintRow& row) {
    return row.correction != nullptr && row.bounds.of_row < 0;
}

// Rows that close a loop of joints, bars and contacts may be redundant, and after a finite rotation they disagree
// slightly: the forces that enforce all of them are huge and move nothing, or jam what rubs. So they are soft,
// s = 1e-4 j_c M^-1 j_c^T, and what that gives way to is taken out of their targets (IslandSolver::lessen), which
// leaves the forces of least norm, with rows in units of their own mobility.
void soften(const Body& a, const Body& b, ConstraintRow& row);

// Whether the row is rigid but for that.
bool is_of_loop(const ConstraintRow& row);

}  // namespace pushfactor::engine
