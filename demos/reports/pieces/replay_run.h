// Replays of the runs of a report.
#pragma once

#include "demos/options/named_run.h"

#include <functional>
#include <string>

namespace pushfactor::demos::reports {

// The page that plays the run, with poses only. `check` is called at each step; its exceptions end the run.
std::string replay_of(const std::string& scene, const OptionTexts& options, const std::function<void()>& check);

}  // namespace pushfactor::demos::reports
