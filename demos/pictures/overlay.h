// What is drawn over the bodies: contact points, forces, push factors and velocities, with a scale and a legend;
// and the colours of islands, and of what is at rest.
#pragma once

#include "demos/options/overlay_choice.h"
#include "demos/runs/scene.h"
#include "demos/text/palette.h"
#include "renderer/picture/picture.h"

#include <string>
#include <vector>

namespace pushfactor::demos::pictures {

// A quantity somewhere in the world.
struct Quantity {
    engine::Vector3 place = engine::Vector3::Zero();  // m
    engine::Vector3 value = engine::Vector3::Zero();  // N or m/s
    std::size_t kind = 0;                             // index into the entries of the overlay's kind
};

// What an overlay consists of: "contact force" and "bar force" of forces, and so on.
struct LegendEntry {
    std::string name;
    Colour colour;
    std::string unit;  // empty for points
};
std::vector<LegendEntry> entries_of(OverlayKind kind);

// Of the last step of the world, at its contact points as they were at the step's start; nothing before the first
// step, except velocities. A force acts on the body that it is drawn on: the movable one of a pair, the upper one
// of two.
std::vector<Quantity> quantities(const BuiltScene& scene, OverlayKind kind);

// Throws UsageError for an overlay that can show nothing, because the scene has no such part.
void require_shown(const BuiltScene& scene, const std::vector<OverlayItem>& overlay);

// Adds one overlay to a picture that draw_list() made of the scene, `units_a_metre` to scale (no matter for points
// and colours of bodies).
void add_overlay(const BuiltScene& scene, OverlayKind kind, double units_a_metre, renderer::Picture& picture);

}  // namespace pushfactor::demos::pictures
