#pragma once

#include "renderer/picture/picture.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace pushfactor::renderer {

// Vertex shader data of a panel's triangle corner. World frame.
struct PanelVertex {
    glm::vec3 position;  // m
    glm::vec3 normal;    // of the front, unit length
    glm::vec3 colour;    // linear light, 0..1
    float opacity;       // 0..1
    float from_edge;     // distance from the outer edge of its triangle, m
    glm::vec2 in_plane;  // coordinates in the panel's plane, m; the first is horizontal
};

// Whether the corners run once around a convex area in one plane, up to a thousandth of its size.
bool flat_and_convex(std::span<const glm::vec3> corners);

// Triangles of all panels, three vertices each, counter-clockwise seen from the front, farthest panel first. Panels
// must satisfy flat_and_convex(); their order in the list does not matter.
std::vector<PanelVertex> panel_triangles(std::span<const Panel> panels, const glm::vec3& eye);

}  // namespace pushfactor::renderer
