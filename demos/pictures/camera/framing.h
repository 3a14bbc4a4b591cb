// Cameras that frame balls: what there is to see of a scene in its current state.
#pragma once

#include "demos/runs/scene.h"
#include "demos/scenes/scene_description.h"

#include <span>
#include <vector>

namespace pushfactor::demos::pictures {

struct Ball {
    engine::Vector3 centre = engine::Vector3::Zero();  // m, world frame
    double radius = 0.0;                               // m
};

// Of a camera, unit length.
struct Axes {
    engine::Vector3 right, up, forward;
};
Axes axes_of(const View& view);

// How far the balls reach to the sides from the middle of the picture, as the tangent of an angle.
double reach_across(std::span<const Ball> balls, const View& view);

// Position in the picture of a point in front of the camera, 0 to 1 from the left and from the top.
Eigen::Vector2d place_in_picture(const engine::Vector3& point, const View& view, double aspect);

// Half the height of what is seen at a distance of 1.
double half_tangent(const View& view);

// From the eye to the target [m].
double distance_of(const View& view);

// The view from the same direction, as close as possible with all balls in the picture and some space around them.
// `aspect` is width over height.
View fitted(const View& view, std::span<const Ball> balls, double aspect);

// The view from the same place with the field of view widened, if necessary, to show `across` to both sides.
View widened(const View& view, double across, double aspect);

// A view in the direction of `view` of all that is `reached`, up to where the picture would show nothing else; at
// least of the bodies at the `start`. `aspect` is width over height.
View overview(const View& view, const std::vector<Ball>& start, std::vector<Ball> reached, double aspect);

// Balls whose hull is the body in this pose: corners without a radius, or a sphere; none for a plane.
std::vector<Ball> hull_of(const BodyDescription& body, const engine::Vector3& position,
                          const engine::Quaternion& orientation);

// The points that bars and joints hold.
std::vector<Ball> held_points(const BuiltScene& scene);

// Balls around the movable bodies of a scene, and the points that they hang on.
std::vector<Ball> movable_balls(const BuiltScene& scene);

// The region around a scene's movable_balls() at its start in which a body is worth being in the picture: from
// farther away than 300 radii or ten times the scene's size it is a dot, or all else is.
Eigen::AlignedBox3d surroundings(std::span<const Ball> start);

}  // namespace pushfactor::demos::pictures
