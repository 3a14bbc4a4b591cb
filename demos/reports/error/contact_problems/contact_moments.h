// Moments of our scenes whose systems FCLib has words for: contacts with Coulomb's friction and nothing else.
#pragma once

#include "demos/options/choices.h"
#include "demos/reports/error/frozen_problem.h"

#include <functional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

struct ContactMoment {
    std::string name;  // a file name: "wall_3_at_0.5s"
    Choices choices;   // `settings.seconds` is the moment
};

// Stacks, heaps, walls, houses of cards and arches, ten each: five members at two moments; of each kind one with
// `quick`.
std::vector<ContactMoment> contact_moments(bool quick);

// Runs to the moment and freezes its system. `check` is called at each step; its exceptions end the run.
FrozenProblem freeze_contacts(const ContactMoment& moment, const std::function<void()>& check);

}  // namespace pushfactor::demos::reports::error
