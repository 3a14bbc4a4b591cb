// The parts that a world is made of: what pushes its bodies, and what restricts them.
// What a scene does not need is not constructed.
#pragma once

#include "engine/body.h"
#include "engine/constraint_row.h"
#include "engine/motion.h"

#include <span>
#include <vector>

namespace pushfactor::engine {

// Adds external forces to the bodies at the start of a step (3.1: "keeps track of all the forces applied").
class ForceSource {
  public:
    virtual ~ForceSource() = default;
    virtual void add_forces(std::span<Body> bodies, double time) = 0;  // s since the start of the world
};

// Appends the rows that restrict the bodies in this step (section 5) and gets back its own answers (6.2.3).
class ConstraintSource {
  public:
    virtual ~ConstraintSource() = default;

    // Appends rows for the state of `bodies` and a step of `dt` [s]. Their order is kept: nobody sorts later.
    virtual void append_rows(std::span<const Body> bodies, double dt, std::vector<ConstraintRow>& rows) = 0;

    // Appends the rows that are missing when the bodies move with `forces`, the constraint forces of the first
    // column [N and N m, one per body], as found with the rows so far; none when nothing is missing. Called again
    // while other sources or this one append some. Since the last call, and in the first one since append_rows(),
    // only the bodies that `changed` (one per body) names have got other forces.
    virtual void append_unforeseen(std::span<const Body> /*bodies*/, std::span<const Vector6> /*forces*/,
                                   std::span<const NewForce> /*changed*/, double /*dt*/,
                                   std::vector<ConstraintRow>& /*rows*/) {}

    // The forces that the next step should begin with, one for each row that the source has appended in this step,
    // in that order: the answers, or something between them and the guesses.
    virtual void remember(std::span<const Lambda> answers) = 0;
};

}  // namespace pushfactor::engine
