// Converts a scene to a picture: bodies, bars, planes.
#pragma once

#include "demos/runs/scene.h"
#include "renderer/picture/picture.h"

#include <optional>
#include <vector>

namespace pushfactor::demos::pictures {

// A bar, spring or joint as it is drawn: between a point of each of two bodies.
struct Link {
    int body_a = 0, body_b = 0;                          // of the world
    engine::Vector3 point_a = engine::Vector3::Zero();   // m, body frame
    engine::Vector3 point_b = engine::Vector3::Zero();   // m, body frame
    engine::Vector3 half_pin = engine::Vector3::Zero();  // m, frame of a: how far a hinge's pin sticks out
    std::optional<double> spring_length{};               // m, unloaded; a straight bar without
    double radius = 0.0;                                 // m
};
// In the order of the picture's bars; the pin of a hinge sticks out of the smaller of its bodies.
std::vector<Link> links_of(const BuiltScene& scene);

// Colours of the bodies as draw_list() has them, sRGB; those of planes mean nothing.
std::vector<glm::vec3> colours_of(const BuiltScene& scene);

// Infinite planes: the level one is the ground, and of others the visible part is drawn.
bool is_level(const engine::Body& plane);

// Of the plane or of the floor that is drawn [m].
std::optional<double> ground_height(const BuiltScene& scene);

// Corners of the convex polygon of `plane` [m] that is above all other planes of the scene and within view,
// counter-clockwise as seen from above the plane. None if the area is negligible.
std::vector<engine::Vector3> plane_outline(const BuiltScene& scene, const engine::Body& plane);

// Of a flat polygon [m^2]: its size is the area, and the corners run counter-clockwise as seen from where it
// points.
engine::Vector3 area_of(const std::vector<engine::Vector3>& polygon);

// Throws UsageError for a body whose place or size is too large or too small for pictures and models, whose numbers
// are floats.
void require_drawable(const BuiltScene& scene);

// The scene as it is now, seen from `view`.
renderer::Picture draw_list(const BuiltScene& scene, const View& view);

}  // namespace pushfactor::demos::pictures
