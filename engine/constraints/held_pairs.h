// What bars and joints have in common: each holds a point of one body at a point of another, and keeps its forces.
#pragma once

#include "engine/base/index.h"
#include "engine/constraints/constraint_source.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <vector>

namespace pushfactor::engine {

// Of an item with `body_a` and `body_b`, indices into the bodies of the world.
template <typename Item>
BodyPair pair_of(const Item& item, std::span<const Body> bodies) {
    return {item.body_a, item.body_b, bodies[at(item.body_a)], bodies[at(item.body_b)]};
}

// The two points `point_a` and `point_b` of an item in the world frame [m].
struct Span {
    Vector3 from, to;
};
template <typename Item>
Span span_of(const Item& item, const BodyPair& bodies) {
    const Body &a = bodies.body_a, &b = bodies.body_b;
    return {a.position + a.orientation * item.point_a, b.position + b.orientation * item.point_b};
}
template <typename Item>
Span span_of(const Item& item, std::span<const Body> bodies) {
    return span_of(item, pair_of(item, bodies));
}

// Consecutive rows, whose errors c are set, that hold one place of a bar or a joint in up to three directions.
struct HeldRows {
    std::span<ConstraintRow> rows;
    const BodyPair& bodies;
    double size;  // m
    double dt;    // s
};

// c' and c'' of a row while nothing acts on its bodies [m/s, m/s^2].
struct Rates {
    double first = 0.0, second = 0.0;
};
using HeldRates = std::array<Rates, 3>;

// The parts of push_held(): the whole push, and whether some of it may have to be kept out of the momenta; and
// that.
bool push_whole(const HeldRows& held, const Correction& correction);
void keep_in_common(const HeldRows& held, const HeldRates& rates);

// Gives the rows their push and `correction`, which must outlive them. `rates()` gives the rates of the rows.
//
// PushKind::curve (erratum 33): bodies go straight on where their path is curved, which leaves an error of
// c'' dt^2 / 2, and the push that takes it back is the momentum with which they follow the curve: not to be kept
// out of the momenta. Everything else in an error, from an impact, a longer step or unsolved rows, would become
// energy, without limit if steps get shorter. So of a push becomes momentum what three measures of the curve have
// in common:
//
//   v              the push itself
//   - c'' dt / 2   by the curve
//   - c'           by the velocities before the step, which belong half a step before the places: momenta change by
//                  j_c^T lambda dt and energy by lambda dt (c'1 + c'2) / 2, so reversing them takes and gives none
//
// It is a share of the last one, or of the second where a body is moved (path.h), and the same in all directions.
// Where what is left of the push is less than that, it is not worth a second column.
template <typename RatesOfRows>
void push_held(const HeldRows& held, const Correction& correction, const RatesOfRows& rates) {
    if (push_whole(held, correction)) keep_in_common(held, rates());
}

// Appends three rows, along the world's x, y and z, that hold a point of each body together [m, world frame]: a
// ball joint (5.2 with length 0).
//
// While it is open, force and reaction act at two points, and would turn the pair by a couple. It is taken from
// both bodies as from one piece, so that both get the same angular acceleration; halves, as of forces in the
// middle, would spin a slender bar about itself. A static body takes half: then they act in the middle.
void append_point_rows(const BodyPair& bodies, const Vector3& on_a, const Vector3& on_b,
                       const Correction& correction, double dt, RowList& rows);

// A source of rows whose items are numbered as RowLabel::point. row_count(item) is the number of rows of one.
template <typename Item, std::size_t most_rows>
class HeldPairs : public ConstraintSource {
  public:
    using Force = std::array<Lambda, most_rows>;

    void append_rows(const StepStart& step, RowList& rows) override {
        for (const std::size_t i : acting_) append_rows_of(i, pair_of(items_[i], step.bodies), step.dt, rows);
    }
    bool can_follow() const override { return true; }
    void remember(std::span<const Lambda> answers) override {
        for (const std::size_t i : acting_) {
            const std::size_t rows = row_count(items_[i]);
            std::copy_n(answers.begin(), rows, forces_[i].begin());
            answers = answers.subspan(rows);
        }
    }
    bool can_leave_out() const override { return true; }
    void leave_out_others(std::span<const Body> bodies, const Awake& awake, std::span<const int>) override {
        acting_.clear();
        for (std::size_t i = 0; i < items_.size(); ++i) {
            if (is_any_moving(bodies, awake, items_[i].body_a, items_[i].body_b)) acting_.push_back(i);
        }
    }
    SomeBodies met_by_moved(const StepStart& step) const override {
        SomeBodies held;
        for (const Item& item : items_) {
            if (step.bodies[at(item.body_a)].is_moved()) held.some.push_back(item.body_b);
            if (step.bodies[at(item.body_b)].is_moved()) held.some.push_back(item.body_a);
        }
        return held;
    }

    // Indices of the items that have rows, in row order; those of resting bodies have none.
    std::span<const std::size_t> acting() const { return acting_; }

    // Solution of the last step, one per item [N], zero for rows that it does not have and before the first step.
    // Set when a run is restored.
    const std::vector<Force>& forces() const { return forces_; }
    void set_forces(std::vector<Force> forces) {
        assert(forces.size() == items_.size());
        forces_ = std::move(forces);
    }

  protected:
    // `cached`: warm start from the forces of the previous step (6.2.3).
    HeldPairs(std::vector<Item> items, const Correction& correction, bool cached)
        : items_(std::move(items)),
          correction_(correction),
          cached_(cached),
          forces_(items_.size()),
          acting_(items_.size()) {
        std::iota(acting_.begin(), acting_.end(), 0);
    }

    std::vector<Item> items_;
    Correction correction_;
    bool cached_;
    std::vector<Force> forces_;
    std::vector<std::size_t> acting_;
};

}  // namespace pushfactor::engine
