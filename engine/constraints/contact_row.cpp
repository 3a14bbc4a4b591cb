#include "engine/constraints/contact_row.h"

namespace pushfactor::engine {

namespace {

// Least corrected penetration beyond the slop, as a share of it: less would keep a second column for nothing.
constexpr double pushed_out = 1e-6;

PushFactor contact_push(double gap, const Correction& correction, double slop, double dt) {
    if (gap > touching_gap(slop)) return {.correcting = 0.0, .lasting = -gap / dt};
    // A body that has been pushed out to the slop stays there up to the tolerance of the solver.
    const double excess = -gap - slop;
    return correct(correction, excess > pushed_out * slop ? excess : 0.0, dt);
}

}  // namespace

void write_contact_row(const PairPoint& point, const Vector3& normal, double gap, const Correction& correction,
                       double slop, double dt, ConstraintRow& row) {
    point.place(row, normal);
    row.push = contact_push(gap, correction, slop, dt);
    row.correction = &correction;
    row.bounds.c_min = 0.0;
    row.error = gap > 0.0 && gap <= touching_gap(slop) ? 0.0 : gap;
    row.label = {.kind = RowKind::contact, .point = 0, .gap = gap};
}

}  // namespace pushfactor::engine
