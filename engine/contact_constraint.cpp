#include "engine/contact_constraint.h"

namespace pushfactor::engine {

namespace {

// How deep a point that has been apart comes to lie, as a share of the slop: deep enough for its row to aim at rest
// from then on, instead of following gaps of rounding size.
constexpr double seat = 1e-3;

PushFactor contact_push(double gap, const Correction& correction, double slop, double dt) {
    if (gap > 0.0) return {.correcting = 0.0, .lasting = -(gap + seat * slop) / dt};
    // A body that has been pushed out to the slop stays there as exactly as the solver is asked to hold it; to
    // correct less than a millionth of the slop would keep a second column alive for nothing.
    const double excess = -gap - slop;
    return correct(correction, excess > 1e-6 * slop ? excess : 0.0, dt);
}

}  // namespace

ConstraintRow& append_contact_row(const PairPoint& point, const Vector3& normal, double gap,
                                  const Correction& correction, double slop, double dt,
                                  std::vector<ConstraintRow>& rows) {
    ConstraintRow& row = rows.emplace_back();
    point.place(row, normal);
    row.push = contact_push(gap, correction, slop, dt);
    row.bounds.c_min = 0.0;
    row.error = gap > 0.0 ? gap + seat * slop : gap;
    row.label = {.kind = RowKind::contact, .point = 0, .gap = gap};
    return row;
}

}  // namespace pushfactor::engine
