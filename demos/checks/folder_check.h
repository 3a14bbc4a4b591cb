// Renders a folder again and compares.
#pragma once

#include "demos/checks/expectation.h"
#include "demos/checks/tolerance.h"
#include "demos/checks/update.h"
#include "demos/checks/verdict.h"
#include "demos/pictures/offscreen_renderer.h"

#include <optional>

namespace pushfactor::demos::checks {

struct Rules {
    std::optional<Tolerance> tolerance{};  // none: exactly() for the same program and driver, else usual()
    bool physics = true;                   // compare it
    std::optional<double> trajectory{};    // m and rad: within that of trajectory.csv, instead of the state hash
};

// Renders the expectation again and compares. New pictures and the new summary go to `update` unless it is null. A
// run that becomes non-finite is a verdict. Throws RunError when interrupted.
FolderVerdict check_folder(const Expectation& expected, const Rules& rules, const FolderJob& job,
                           pictures::OffscreenRenderer& offscreen, Update* update);

}  // namespace pushfactor::demos::checks
