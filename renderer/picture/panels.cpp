#include "renderer/picture/panels.h"

#include <glm/geometric.hpp>
#include <glm/gtc/color_space.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace pushfactor::renderer {
namespace {

// Along the normal of the front, as long as twice the area.
glm::vec3 area_vector(std::span<const glm::vec3> corners) {
    glm::vec3 sum(0.0f);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        sum += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    }
    return sum;
}

glm::vec3 middle(std::span<const glm::vec3> corners) {
    glm::vec3 sum(0.0f);
    for (const glm::vec3& corner : corners) sum += corner / static_cast<float>(corners.size());
    return sum;
}

// Compares numbers only, so that equal keys mean equal panels, whose order does not matter.
bool drawn_before(const Panel& a, const Panel& b, const glm::vec3& eye) {
    const double a_distance = glm::distance(glm::dvec3(middle(a.corners)), glm::dvec3(eye));
    const double b_distance = glm::distance(glm::dvec3(middle(b.corners)), glm::dvec3(eye));
    if (a_distance != b_distance) return a_distance > b_distance;
    const auto numbers = [](const glm::vec3& v) { return std::tuple(v.x, v.y, v.z); };
    const auto look = [&](const Panel& panel) { return std::tuple(panel.opacity, numbers(panel.colour)); };
    if (look(a) != look(b)) return look(a) < look(b);
    return std::ranges::lexicographical_compare(a.corners, b.corners, {}, numbers, numbers);
}

void add_triangles(std::vector<PanelVertex>& vertices, const Panel& panel) {
    const glm::vec3 normal = glm::normalize(area_vector(panel.corners));
    const bool level = std::abs(normal.y) > 0.999f;
    const glm::vec3 along =
        glm::normalize(glm::cross(level ? glm::vec3(0.0f, 0.0f, -1.0f) : glm::vec3(0.0f, 1.0f, 0.0f), normal));
    const glm::vec3 across = glm::cross(normal, along);
    const glm::vec3 colour = glm::convertSRGBToLinear(panel.colour);
    const auto vertex = [&](const glm::vec3& position, float from_edge) -> PanelVertex {
        return {position,      normal,    colour,
                panel.opacity, from_edge, {glm::dot(position, along), glm::dot(position, across)}};
    };

    // One triangle for each edge, with the middle as its third corner: the distance from the edge runs
    // linearly over it.
    const glm::vec3 centre = middle(panel.corners);
    for (std::size_t i = 0; i < panel.corners.size(); ++i) {
        const glm::vec3& first = panel.corners[i];
        const glm::vec3& second = panel.corners[(i + 1) % panel.corners.size()];
        const float length = glm::distance(first, second);
        if (length == 0.0f) continue;
        const float height = glm::length(glm::cross(second - first, centre - first)) / length;
        vertices.insert(vertices.end(), {vertex(first, 0.0f), vertex(second, 0.0f), vertex(centre, height)});
    }
}

}  // namespace

bool flat_and_convex(std::span<const glm::vec3> corners) {
    constexpr float tolerance = 1e-3f;
    if (corners.size() < 3) return false;
    float size = 0.0f;
    for (const glm::vec3& corner : corners) size = std::max(size, glm::distance(corner, corners[0]));
    const glm::vec3 area = area_vector(corners);
    // Written so that what overflows is refused.
    if (!(glm::length(area) > tolerance * tolerance * size * size)) return false;

    const glm::vec3 normal = glm::normalize(area);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (!(std::abs(glm::dot(normal, corners[i] - corners[0])) <= tolerance * size)) return false;
        const glm::vec3 edge = corners[(i + 1) % corners.size()] - corners[i];
        const glm::vec3 inwards = glm::cross(normal, edge);
        for (const glm::vec3& corner : corners) {
            if (!(glm::dot(inwards, corner - corners[i]) >= -tolerance * size * size)) return false;
        }
    }
    return true;
}

std::vector<PanelVertex> panel_triangles(std::span<const Panel> panels, const glm::vec3& eye) {
    std::vector<const Panel*> sorted;
    for (const Panel& panel : panels) sorted.push_back(&panel);
    std::ranges::sort(sorted, [&](const Panel* a, const Panel* b) { return drawn_before(*a, *b, eye); });

    std::vector<PanelVertex> vertices;
    for (const Panel* panel : sorted) add_triangles(vertices, *panel);
    return vertices;
}

}  // namespace pushfactor::renderer
