// Impacts within a step, in the order in which they happen.
//
// If some pair with restitution is about to meet, the bodies around it fly through the step before its rows are
// written: whenever two of them hit each other, that one impact is solved (impact_solver.h), they fly on with other
// velocities, and what they meet next is searched anew. So one body may take part in many impacts of a step, a row
// of touching balls passes a blow on from ball to ball, and none flies through another one.
//
// What is left for the rows of the step is what does not hit anything but is held or lies: the bodies that were hit
// enter it with their new momenta, and with the place where they end if nothing holds them.
//
// In a heap impacts with restitution below 1 follow each other without end. A pair whose rebounds have left a tenth
// of its speed is in contact for the rest of the step.
//
// Bodies that lie on something do not fall while they fly. Impacts that are slower than ImpactLimits say are
// contacts, as everything is that rests.
//
// Deviations: 8.2 adds the rebound to the push of the row, so that all impacts of a step are one (`paper` does
// that, restitution.h).
#pragma once

#include "engine/base/index.h"
#include "engine/bodies/awake.h"
#include "engine/constraints/constraint_source.h"
#include "engine/impacts/flight.h"
#include "engine/step/step_rows.h"

#include <span>
#include <vector>

namespace pushfactor::engine {

class Impacts {
  public:
    virtual ~Impacts() = default;

    // Lets bodies that are about to rebound fly through the step, whose rows have been appended, and those that
    // they hit. Returns whether there are any. With resting() bodies hit (not in `awake`) nothing else is valid:
    // they have to be woken first.
    virtual bool fly(const StepStart& step, const RowSources& sources, std::span<const ConstraintRow> rows,
                     const Awake& awake) = 0;

    // Of the last call:
    std::span<const int> followed() const { return followed_; }  // bodies, ascending
    const Flight& flight_of(int body) const { return flights_[at(flight_of_[at(body)])]; }
    std::span<const int> resting() const { return resting_; }
    int count() const { return count_; }                     // of impacts
    bool is_cut_short() const { return is_cut_short_; }      // there were more
    double external_work() const { return external_work_; }  // J, of belts and moved bodies

  protected:
    std::vector<Flight> flights_;
    std::vector<int> flight_of_;  // by body, -1: none yet
    std::vector<int> followed_, resting_;
    int count_ = 0;
    bool is_cut_short_ = false;
    double external_work_ = 0.0;
};

}  // namespace pushfactor::engine
