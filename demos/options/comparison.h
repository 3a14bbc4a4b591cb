// Runs of one scene that differ in one option: the panels of a picture.
#pragma once

#include "demos/options/choices.h"

#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos {

struct ComparedRun {
    std::string label;  // "push none"; empty when there is only one
    Choices choices;
};

// Notes the options of the command line that have no effect in any of the runs, because of the scene or of another
// option. They are not refused: the commands of maps and pages name every option that they vary.
void note_idle(const GivenOptions& given, std::span<const ComparedRun> runs);

// One panel per value of --compare, or a single one without it. Throws UsageError as understand() does, and for an
// option that cannot be compared.
std::vector<ComparedRun> compared_runs(const std::string& scene, const GivenOptions& given);

}  // namespace pushfactor::demos
