// A view of all motion, for scenes without a camera.
#pragma once

#include "demos/pictures/camera/framing.h"

#include <vector>

namespace pushfactor::demos::pictures {

// A view in the direction of `view` of all that is `reached`, up to where the picture would show nothing else; at
// least of the bodies at the `start`. `aspect` is width over height.
View overview(const View& view, const std::vector<Ball>& start, std::vector<Ball> reached, double aspect);

}  // namespace pushfactor::demos::pictures
