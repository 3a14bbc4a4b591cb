// Polyhedra in pictures: their meshes, what is refused, and what single pixels show.
#include "renderer/base/renderer_error.h"
#include "renderer/meshes/convex_shape.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <glm/geometric.hpp>

#include <map>

using namespace pushfactor::renderer;

namespace {

// Where an instance with the extents of the shape places a vertex.
glm::vec3 placed(const Vertex& vertex, const ConvexShape& shape) {
    const float bevel = roundness(shape);
    return vertex.corner * (half_extents(shape) - bevel) + vertex.normal * bevel;
}

ConvexShape cube() {
    ConvexShape shape;
    for (int k = 0; k < 8; ++k) {
        shape.corners.emplace_back((k & 1) != 0 ? 1.0f : -1.0f, (k & 2) != 0 ? 1.0f : -1.0f,
                                   (k & 4) != 0 ? 1.0f : -1.0f);
    }
    shape.faces = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
    return shape;
}

Picture with(const std::shared_ptr<const ConvexShape>& shape) {
    return {.camera = from_the_front, .bodies = {{.shape = shape, .colour = red}}};
}

}  // namespace

TEST_CASE("the bevelled mesh of a polyhedron is closed, faces outwards and stays within the polyhedron") {
    for (const ConvexShape& shape : {cube(), *wedge()}) {
        const Mesh mesh = convex_mesh(shape);
        std::map<std::pair<int, int>, int> edges;
        float volume = 0.0f;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) { return placed(mesh.vertices[mesh.indices[i + k]], shape); };
            const glm::vec3 across = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
            volume += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6.0f;
            for (std::size_t k = 0; k < 3; ++k) {
                CHECK(glm::dot(across, mesh.vertices[mesh.indices[i + k]].normal) > 0.0f);
                ++edges[{mesh.indices[i + k], mesh.indices[i + (k + 1) % 3]}];
            }
        }
        for (const auto& [edge, count] : edges) {
            CHECK(count == 1);
            CHECK(edges.contains({edge.second, edge.first}));
        }
        const float whole = shape == cube() ? 8.0f : 1.26f;
        CHECK(volume < whole);
        CHECK(volume > 0.97f * whole);  // the bevels are narrow
    }
}

TEST_CASE("a cube as a polyhedron looks as a box does") {
    OffscreenRenderer offscreen(160, 90);
    const Image polyhedron = offscreen.render(with(std::make_shared<const ConvexShape>(cube())));
    const Image box =
        offscreen.render({.camera = from_the_front, .bodies = {{.shape = Box{glm::vec3(1.0f)}, .colour = red}}});
    int differing = 0;
    for (std::size_t i = 0; i < box.rgb.size(); ++i)
        differing += std::abs(box.rgb[i] - polyhedron.rgb[i]) > 4 ? 1 : 0;
    CHECK(differing < 100);  // of 43,200; along the edges
}

TEST_CASE("a polyhedron is seen where it is, hides what is behind it and casts a shadow") {
    Picture picture{.camera = from_above, .ground = Ground{.height = -3.0f}};
    OffscreenRenderer offscreen(160, 90);
    const Image bare = offscreen.render(picture);
    picture.bodies.push_back({.shape = wedge(), .colour = red});
    picture.bodies.push_back({.position = {0.0f, -1.5f, 0.0f}, .shape = Sphere{0.3f}, .colour = blue});
    const Image image = offscreen.render(picture);
    CHECK(is_red(image.pixel(80, 45)));
    int darker = 0;
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 160; ++x) {
            CHECK(!is_blue(image.pixel(x, y)));
            darker += brightness(image, x, y) < brightness(bare, x, y) - 60 && !is_red(image.pixel(x, y)) ? 1 : 0;
        }
    }
    CHECK(darker > 20);
}

TEST_CASE("shapes that are no surface are refused by name") {
    const auto said = [](ConvexShape shape) -> std::string {
        try {
            check(with(std::make_shared<const ConvexShape>(std::move(shape))));
        } catch (const RendererError& error) {
            return error.what();
        }
        return "";
    };
    CHECK(said(cube()).empty());
    ConvexShape open = cube();
    open.faces.pop_back();
    CHECK(said(open) == "picture: bodies[0].shape.faces do not close a surface");
    ConvexShape missing = cube();
    missing.faces[0][0] = 8;
    CHECK(said(missing) == "picture: bodies[0].shape.faces have corners that are not there");
    CHECK_THROWS_AS(check(with(nullptr)), RendererError);
}
