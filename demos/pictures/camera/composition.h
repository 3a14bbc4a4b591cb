// A camera that fills its picture with a subject.
#pragma once

#include "demos/pictures/camera/outline.h"
#include "demos/scenes/scene_description.h"

#include <span>

namespace pushfactor::demos::pictures {

// The part of the picture that the points span, 0 to 1 from left and top, seen by `view`; beyond that range for
// points outside of the picture.
struct Extent {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
};
Extent extent_of(std::span<const engine::Vector3> points, const View& view, double aspect);

// A view of all points from about the direction of `view`, as close as possible: it is turned by up to 45 degrees
// and raised by up to 20 where that fills a picture of this aspect (width over height) much better. Where the
// subject leaves room to the sides, it is in the middle together with its shadow.
View composed(const View& view, const Subject& subject, double aspect);

}  // namespace pushfactor::demos::pictures
