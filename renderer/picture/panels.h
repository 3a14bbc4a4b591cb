#pragma once

#include "renderer/picture/picture.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace pushfactor::renderer {

// One corner of a panel's triangles, as the vertex shader wants it. World frame.
struct PanelVertex {
    glm::vec3 position;  // m
    glm::vec3 normal;    // of the front, unit length
    glm::vec3 colour;    // linear light, 0..1
    float opacity;       // 0..1
    float from_edge;     // how far inside of the edge that its triangle lies at, m
    glm::vec2 in_plane;  // coordinates in the panel's plane, m; the first runs horizontally
};

// Whether the corners run once around a convex area in one plane, to within a thousandth of its size.
bool flat_and_convex(std::span<const glm::vec3> corners);

// The triangles of all panels, three vertices each and counter-clockwise seen from the front, of the farthest
// panel first. Panels that flat_and_convex() accepts; their order in the list makes no difference.
std::vector<PanelVertex> panel_triangles(std::span<const Panel> panels, const glm::vec3& eye);

}  // namespace pushfactor::renderer
