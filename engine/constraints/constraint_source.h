// What restricts the bodies of a world: rows, as parts that a scene has or has not.
#pragma once

#include "engine/base/threads.h"
#include "engine/bodies/awake.h"
#include "engine/bodies/body.h"
#include "engine/bodies/motion.h"
#include "engine/constraints/row_list.h"

#include <span>

namespace pushfactor::engine {

// Whether rows between two bodies may move something: one of them can, and is not at rest.
inline bool is_any_moving(std::span<const Body> bodies, const Awake& awake, int a, int b) {
    const auto moves = [&](int body) {
        return awake.has(body) && !bodies[static_cast<std::size_t>(body)].is_static();
    };
    return moves(a) || moves(b);
}

// A step as it begins.
struct StepStart {
    std::span<const Body> bodies;  // with their external forces
    double dt = 0.0;               // s, of the step
    double time = 0.0;             // s since the start of the world
    Threads* threads = nullptr;    // that may share the work; null: one thread. The rows do not depend on them
};

// Appends the rows that restrict the bodies in this step (section 5) and gets back its own answers (6.2.3).
class ConstraintSource {
  public:
    virtual ~ConstraintSource() = default;

    // Appends the rows of a step. Whole-step solvers keep their order.
    virtual void append_rows(const StepStart& step, RowList& rows) = 0;

    // Appends the rows that are missing when the bodies move with `forces`, the constraint forces of the first
    // column [N and N m, one per body], as found with the rows so far; none when nothing is missing. Called again
    // while other sources or this one append some. Since the last call, and in the first one since append_rows(),
    // only the bodies that `changed` (one per body) names have got other forces.
    virtual void append_unforeseen(const StepStart& /*step*/, std::span<const Vector6> /*forces*/,
                                   std::span<const NewForce> /*changed*/, RowList& /*rows*/) {}

    // Whether the rows of the source stay as they are however `body` turns about its centre, as those of a ball do.
    // Where all sources say so, what rests may go on turning (rest.h).
    virtual bool turns_unseen(int /*body*/) const { return false; }

    // Which bodies at rest have other rows in a step that begins at `until` than in one at `from` [s], although
    // nothing has moved.
    virtual SomeBodies changed_anew(double /*from*/, double /*until*/) const { return {}; }

    // Whether the source leaves out rows between bodies that rest, or rest and are static, and remembers what it
    // had for them (rest.h). Bodies that rows of another one act on do not come to rest.
    virtual bool can_leave_out() const { return false; }
    // From now on those awake are these; called before the first step in which they are others.
    virtual void leave_out_others(std::span<const Body> /*bodies*/, const Awake& /*awake*/) {}

    // The forces that the next step should begin with, one for each row that the source has appended in this step,
    // in that order: the answers, or something between them and the guesses.
    virtual void remember(std::span<const Lambda> answers) = 0;
};

}  // namespace pushfactor::engine
