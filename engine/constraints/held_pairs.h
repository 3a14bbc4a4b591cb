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
