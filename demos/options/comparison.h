// The same scene several times, with one option different: the panels of one picture.
#pragma once

#include "demos/options/choices.h"

#include <string>
#include <vector>

namespace pushfactor::demos {

struct ComparedRun {
    std::string label;  // "push none"; empty when there is only one
    Choices choices;
};

// One panel a value of --compare, or just one without it. Throws UsageError as understand() does, and for an option
// that cannot be compared.
std::vector<ComparedRun> compared_runs(const std::string& scene, const GivenOptions& given);

}  // namespace pushfactor::demos
