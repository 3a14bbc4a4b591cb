// Interface of the parts that constrain the bodies of a world with rows.
#pragma once

#include "engine/base/threads.h"
#include "engine/bodies/awake.h"
#include "engine/bodies/body_pair.h"
#include "engine/bodies/motion.h"
#include "engine/constraints/row_list.h"

#include <span>

namespace pushfactor::engine {

// Whether rows between two bodies can move something: one of them is movable and awake.
inline bool is_any_moving(std::span<const Body> bodies, const Awake& awake, int a, int b) {
    const auto moves = [&](int body) {
        return awake.has(body) && !bodies[static_cast<std::size_t>(body)].is_static();
    };
    return moves(a) || moves(b);
}

// State at the start of a step.
struct StepStart {
    std::span<const Body> bodies;               // with the external forces
    double dt = 0.0;                            // s
    double time = 0.0;                          // s since the start of the world
    OrientationStep rotate = rotate_splitting;  // how bodies turn in the step
    Threads* threads = nullptr;    // that may share the work; null: one thread. The rows do not depend on them
    Vector3 up = Vector3::Zero();  // against gravity, unit length, world frame; zero without gravity
    std::span<const Strayed> strayed{};  // with their momenta after the impacts
};

// Appends the rows that constrain the bodies in this step (section 5) and stores their solution for warm
// starting (6.2.3).
class ConstraintSource {
  public:
    virtual ~ConstraintSource() = default;

    // Appends the rows of a step. Whole-step solvers keep their order.
    virtual void append_rows(const StepStart& step, RowList& rows) = 0;

    // Appends rows that are missing when the bodies move with `forces`, the constraint forces of the first
    // column [N and N m, one per body] found with the rows so far; none if nothing is missing. Called again as
    // long as any source appends rows. Only bodies marked in `changed` (one per body) have other forces than in
    // the last call (than after append_rows() in the first one).
    virtual void append_unforeseen(const StepStart& /*step*/, std::span<const Vector6> /*forces*/,
                                   std::span<const char> /*changed*/, RowList& /*rows*/) {}

    // Whether append_rows_of() is there: then small steps follow the axes of these rows. Other rows keep theirs for
    // the step.
    virtual bool can_follow() const { return false; }
    // Appends the rows of item `index` (RowLabel::point) again, in a step of `dt` [s] for bodies that have moved.
    virtual void append_rows_of(std::size_t /*index*/, const BodyPair& /*bodies*/, double /*dt*/,
                                RowList& /*rows*/) const {}

    // Energy that springs hold [J], which belongs to the scene like that of gravity.
    virtual double stored_energy(std::span<const Body> /*bodies*/) const { return 0.0; }

    // Whether the rows of the source do not change when `body` turns about its centre, as for a ball. A body
    // that is at rest may go on turning if this holds for all sources (rest.h).
    virtual bool turns_unseen(int /*body*/) const { return false; }

    // Resting bodies whose rows in a step that begins at `until` differ from those at `from` [s] although
    // nothing has moved.
    virtual SomeBodies changed_anew(double /*from*/, double /*until*/) const { return {}; }

    // Bodies that a moved body (path.h) of this step holds or may meet in it; those that rest wake. A source that
    // omits rows of resting bodies has to tell, because no force of theirs can.
    virtual SomeBodies met_by_moved(const StepStart& /*step*/) const { return {}; }

    // Whether the source can omit rows between resting bodies, or resting and static ones, and keeps their
    // forces meanwhile (rest.h). If not, bodies with rows of this source do not come to rest.
    virtual bool can_leave_out() const { return false; }
    // Sets the awake bodies from now on; called before the first step in which they differ, by those that
    // `changed`. All are awake at first.
    virtual void leave_out_others(std::span<const Body> /*bodies*/, const Awake& /*awake*/,
                                  std::span<const int> /*changed*/) {}

    // Forces to start the next step with, one per row that the source appended in this step, in that order: the
    // solution, or something between it and the warm start.
    virtual void remember(std::span<const Lambda> answers) = 0;
};

}  // namespace pushfactor::engine
