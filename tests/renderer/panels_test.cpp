#include "renderer/picture/panels.h"

#include "tests/catch.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <vector>

using namespace pushfactor::renderer;

namespace {

using Corners = std::vector<glm::vec3>;

const Corners square{{0.0f, 0.0f, 0.0f}, {2.0f, 0.0f, 0.0f}, {2.0f, 2.0f, 0.0f}, {0.0f, 2.0f, 0.0f}};

}  // namespace

TEST_CASE("Convex polygons in one plane are accepted, wherever they are") {
    for (const glm::vec3 offset : {glm::vec3(0.0f), glm::vec3(-30.0f, 100.0f, 7.0f)}) {
        Corners moved = square;
        for (glm::vec3& corner : moved) corner = 0.3f * corner + offset;
        CHECK(flat_and_convex(moved));
        std::ranges::reverse(moved);
        CHECK(flat_and_convex(moved));
    }
    CHECK(flat_and_convex(Corners{{0.0f, 0.0f, 0.0f}, {-4.0f, 4.0f, 4.0f}, {4.0f, 4.0f, 4.0f}}));
}

TEST_CASE("What has no area, a dent, a fold or crossing edges is not") {
    CHECK_FALSE(flat_and_convex(Corners{}));
    CHECK_FALSE(flat_and_convex(Corners{square[0], square[1]}));
    CHECK_FALSE(flat_and_convex(Corners{square[0], square[1], square[1]}));
    CHECK_FALSE(flat_and_convex(Corners{square[0], square[1], 2.0f * square[1]}));
    CHECK_FALSE(flat_and_convex(Corners{square[0], square[2], square[1], square[3]}));
    Corners dented = square;
    dented[2] = {0.5f, 0.5f, 0.0f};
    CHECK_FALSE(flat_and_convex(dented));
    Corners folded = square;
    folded[2].z = 0.1f;
    CHECK_FALSE(flat_and_convex(folded));
    CHECK_FALSE(flat_and_convex(Corners{1e38f * square[0], 1e38f * square[1], 1e38f * square[2]}));
}

TEST_CASE("A panel's triangles fill it and face where it faces") {
    const std::vector<Panel> panels{{.corners = square}};
    const std::vector<PanelVertex> vertices = panel_triangles(panels, {1.0f, 1.0f, 5.0f});
    REQUIRE(vertices.size() == 12);
    float area = 0.0f;
    for (std::size_t i = 0; i < vertices.size(); i += 3) {
        const glm::vec3& first = vertices[i].position;
        area += 0.5f * glm::cross(vertices[i + 1].position - first, vertices[i + 2].position - first).z;
        CHECK(vertices[i].normal.z == Approx(1.0f));
        CHECK(vertices[i].from_edge == 0.0f);
        CHECK(vertices[i + 1].from_edge == 0.0f);
        CHECK(vertices[i + 2].from_edge == Approx(1.0f));  // m, from the middle to an edge
    }
    CHECK(area == Approx(4.0f));
}
