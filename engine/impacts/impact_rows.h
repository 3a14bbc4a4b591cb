// The rows of one impact: those of its contact points, at the time at which the bodies meet.
#pragma once

#include "engine/constraints/contact_constraints.h"

namespace pushfactor::engine {

struct ImpactTime {
    double time = 0.0;  // s since the start of the world, when its step began
    double dt = 0.0;    // s, of the step
};

// Appends per point of the touch a contact row and, with friction, its two friction rows. The bodies have the
// velocities with which they meet. The forces of the rows stand for impulses: bounds in newtons act for the step.
void append_impact_rows(const ContactConstraints& contacts, const collision::Touch& touch, const BodyPair& bodies,
                        const ImpactTime& when, RowList& rows);

}  // namespace pushfactor::engine
