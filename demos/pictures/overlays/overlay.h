// Overlays: contact points, forces, torques, push factors and velocities, with scale and legend, colours of islands
// and of bodies at rest, and lines between bodies that do not touch.
#pragma once

#include "demos/base/text/palette.h"
#include "demos/options/look_choices.h"
#include "demos/runs/scene.h"
#include "renderer/picture/picture.h"

#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos::pictures {

// Of bodies that an overlay has nothing to say of.
inline constexpr std::string_view colour_of_none = "ivory";

// A line of an overlay's legend: "contact force" or "joint force" of forces, and so on.
struct LegendEntry {
    std::string name;
    Colour colour;
    std::string unit;  // empty for points
};
std::vector<LegendEntry> entries_of(OverlayKind kind);

struct Quantity {
    engine::Vector3 place = engine::Vector3::Zero();  // m
    engine::Vector3 value = engine::Vector3::Zero();  // N, N m or m/s; of lines m
    std::size_t kind = 0;                             // index into the entries of the overlay's kind
};

// Quantities of the world's last step, at the contact points of the start of the step. Before the first step only
// what does not come from rows: velocities, forces and torques from outside, pairs that do not touch. A force is
// drawn on the body that it acts on: the movable one of a pair, else the upper one.
std::vector<Quantity> quantities(const BuiltScene& scene, OverlayKind kind);

// Throws UsageError for an overlay of a part that the scene lacks.
void require_shown(const BuiltScene& scene, const std::vector<OverlayItem>& overlay);

// Adds an overlay to a picture that draw_list() made of the scene. `units_a_metre` scales arrows and is ignored
// otherwise.
void add_overlay(const BuiltScene& scene, OverlayKind kind, double units_a_metre, renderer::Picture& picture);

}  // namespace pushfactor::demos::pictures
