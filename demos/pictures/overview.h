// The camera of a scene that brings none.
#pragma once

#include "demos/options/comparison.h"
#include "demos/options/frame_options.h"

#include <vector>

namespace pushfactor::demos::pictures {

// Gives the descriptions of the panels a view that shows all that moves at all frames, found by a run of its own;
// does nothing where they have a camera or one was chosen. Bodies that get so far away that they could not be seen
// in a picture of all are followed only part of their way.
void add_overview(std::vector<ComparedRun>& panels, const std::vector<std::vector<Frame>>& frames);

}  // namespace pushfactor::demos::pictures
