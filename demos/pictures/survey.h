// What a run is going to show, found by a run of its own before the first picture: physics costs little beside
// pictures, and a scale or a camera that changed from frame to frame would say nothing. Only those who ask for
// something that depends on it pay for it.
#pragma once

#include "demos/options/comparison.h"
#include "demos/pictures/framing.h"
#include "demos/runs/scene.h"

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace pushfactor::demos::pictures {

struct Survey {
    std::vector<Ball> reached;  // around all that moves, at all frames of all panels
    std::map<OverlayKind, double>
        typical;  // N or m/s: median over the frames of the largest value in any panel; absent for none
    std::set<std::pair<OverlayKind, std::size_t>> shown;  // entries of which there is something to see
};

// `frames` are those of the panels, in the same order.
Survey survey(const std::vector<ComparedRun>& panels, const std::vector<std::vector<Frame>>& frames);

// Around the movable bodies of a scene as it is now, and the points that they hang on.
std::vector<Ball> movable_balls(const BuiltScene& scene);

}  // namespace pushfactor::demos::pictures
