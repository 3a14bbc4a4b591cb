// A camera for scenes without one.
#pragma once

#include "demos/options/comparison.h"
#include "demos/options/frame_options.h"

#include <vector>

namespace pushfactor::demos::pictures {

// Gives the panels a view that shows all motion in all frames, found by a separate run; does nothing if the scene
// has a camera or one was given. Bodies that fly so far that the picture would show nothing else are followed only
// part of their way.
void add_overview(std::vector<ComparedRun>& panels, const std::vector<std::vector<Frame>>& frames);

}  // namespace pushfactor::demos::pictures
