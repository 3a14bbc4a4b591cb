#include "engine/constraints/contact_row.h"

namespace pushfactor::engine {

namespace {

// Gap up to which a point counts as touching, and its row aims at rest, as a share of the slop. Closing gaps of
// rounding size would shake bodies that are placed in contact.
constexpr double touching = 1e-3;
// Least penetration beyond the slop that is corrected, as a share of it: less would keep a second column for
// nothing.
constexpr double pushed_out = 1e-6;

PushFactor contact_push(double gap, const Correction& correction, double slop, double dt) {
    if (gap > touching * slop) return {.correcting = 0.0, .lasting = -gap / dt};
    // A body that has been pushed out to the slop stays there as exactly as the solver is asked to hold it.
    const double excess = -gap - slop;
    return correct(correction, excess > pushed_out * slop ? excess : 0.0, dt);
}

}  // namespace

void write_contact_row(const PairPoint& point, const Vector3& normal, double gap, const Correction& correction,
                       double slop, double dt, ConstraintRow& row) {
    point.place(row, normal);
    row.push = contact_push(gap, correction, slop, dt);
    row.bounds.c_min = 0.0;
    row.error = gap > 0.0 && gap <= touching * slop ? 0.0 : gap;
    row.label = {.kind = RowKind::contact, .point = 0, .gap = gap};
}

}  // namespace pushfactor::engine
