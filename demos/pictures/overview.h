// A camera for scenes without one.
#pragma once

#include "demos/options/comparison.h"
#include "demos/options/frame_options.h"
#include "demos/pictures/survey.h"

#include <vector>

namespace pushfactor::demos::pictures {

// Width over height of the narrowest panel that may be needed for so many.
double least_aspect(const FrameChoices& frames, std::size_t panels);

// Gives the panels a view that shows all motion in all frames, found by the survey; does nothing if the scene
// has a camera or one was given. Bodies that fly so far that the picture would show nothing else are followed only
// part of their way.
void add_overview(std::vector<ComparedRun>& panels, SurveyOnce& survey);

}  // namespace pushfactor::demos::pictures
