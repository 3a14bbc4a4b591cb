// A run as one glTF file, for Blender and other programs that show animated scenes.
#pragma once

#include "demos/pictures/camera/survey.h"
#include "demos/runs/records.h"
#include "demos/runs/simulation.h"

#include <filesystem>
#include <memory>

namespace pushfactor::demos::pictures {

// Throws UsageError for a file name that does not end in .glb, stills, a comparison, an overlay that colours
// bodies, and a run that is too long for a file of this kind.
void check_glb(const std::filesystem::path& file, const Choices& choices);

// The glTF 2.0 file (.glb) of a run that is at its start: a node per body, named as in the scene, one per bar, a
// camera and a sun. Key n of an animation is the state at t = n / fps of the film that `choices` describe. Arrows,
// lines and points of overlays are nodes whose scale is 0 while there are fewer of their kind. finish() writes the
// file of the frames so far.
//
// Numbers are floats, so that a coordinate below 32 m is exact to 1e-6 m. Memory per frame: 28 bytes for each body
// that can move, 24 for each bar and mark.
//
// `run` is one; the survey is made where needs_survey() asks for one. Throws UsageError as check_glb() and
// require_shown() do, and OutputError if the file cannot be created.
std::unique_ptr<Record> glb_record(const std::filesystem::path& file, const std::vector<ComparedRun>& run,
                                   SurveyOnce& survey, const Simulation& start);

}  // namespace pushfactor::demos::pictures
