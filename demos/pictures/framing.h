// Cameras that show what they should.
#pragma once

#include "demos/scenes/scene_description.h"

#include <span>

namespace pushfactor::demos::pictures {

struct Ball {
    engine::Vector3 centre = engine::Vector3::Zero();  // m, world frame
    double radius = 0.0;                               // m
};

// How far the balls reach from the middle of the picture, as tangents of angles: half its width and its height.
struct Reach {
    double across = 0.0, up = 0.0;
};
Reach reach_of(std::span<const Ball> balls, const View& view);

// Where a point in front of the camera is seen: 0 to 1 from the left and from the top of the picture.
struct Place {
    double x = 0.0, y = 0.0;
};
Place place_in_picture(const engine::Vector3& point, const View& view, double aspect);

// Half the height of what is seen at a distance of 1.
double half_tangent(const View& view);

// The same direction, as near as shows all balls with some space around them. `aspect` is width over height.
View fitted(const View& view, std::span<const Ball> balls, double aspect);

// The same place with a field of view that shows `across` to both sides, if it does not yet.
View widened(const View& view, double across, double aspect);

}  // namespace pushfactor::demos::pictures
