#pragma once

#include "renderer/meshes/convex_shape.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace pushfactor::renderer {

// Camera. World frame, y up, metres. The distance from eye to target is the scale of the picture: haze and the
// spacing of the ground's lines are proportional to it.
struct Camera {
    glm::vec3 eye{0.0f, 5.0f, 20.0f};
    glm::vec3 target{0.0f};
    float vertical_field_of_view_degrees = 38.0f;  // in (0, 180)

    bool operator==(const Camera&) const = default;
};

// Shapes of bodies, in the body frame. Edges are slightly bevelled.
struct Box {
    glm::vec3 half_extents{0.5f};  // m, >= 0
};

// Its eight octants are alternately light and dark, so that spin is visible.
struct Sphere {
    float radius = 0.5f;  // m, >= 0
};

// Not null. Bodies with equal shapes share what is drawn of them.
using Polyhedron = std::shared_ptr<const ConvexShape>;

struct Body {
    glm::vec3 position{0.0f};                       // of the shape's origin, world frame, m
    glm::quat orientation{1.0f, 0.0f, 0.0f, 0.0f};  // body to world, unit length
    std::variant<Box, Sphere, Polyhedron> shape{};
    glm::vec3 colour{0.5f};  // sRGB, each 0..1
    std::size_t index = 0;   // which body it is, for the caller; drawing does not depend on it
};

// A round rod with round ends that extend its radius beyond the two points. Always at least about 1.2 pixels wide.
struct Bar {
    glm::vec3 from{0.0f};                // world frame, m
    glm::vec3 to{0.0f, 1.0f, 0.0f};      // world frame, m
    float radius = 0.02f;                // m, >= 0
    glm::vec3 colour{0.3f, 0.3f, 0.3f};  // sRGB, each 0..1
};

// A flat, convex, translucent polygon with a thin outline and faint lines like those of the ground. Its front is
// the side from which the corners run counter-clockwise; the back is drawn fainter, so that the walls of a
// container with fronts facing inwards do not hide its contents. Receives shadows and casts none.
struct Panel {
    std::vector<glm::vec3> corners{};  // at least 3, world frame, m
    glm::vec3 colour{0.6f};            // sRGB, each 0..1
    float opacity = 0.3f;              // of the front, 0 (only the lines are visible) to 1

    bool operator==(const Panel&) const = default;
};

// An infinite horizontal plane, visible from above only. Lines are 1 m apart, every fifth is stronger; from a
// distance of 60 m on they are 10 m apart, then 100 m, and below 6 m they are 0.1 m apart.
struct Ground {
    float height = 0.0f;  // y, m

    bool operator==(const Ground&) const = default;
};

// Arrows and dots are drawn in 2D over everything else, with a width independent of distance, so that they are
// visible inside bodies. Nothing is drawn for points behind the eye.
struct Arrow {
    glm::vec3 from{0.0f};            // world frame, m
    glm::vec3 to{0.0f, 1.0f, 0.0f};  // the tip, world frame, m; an arrow that points at the eye is invisible
    glm::vec3 colour{0.0f};          // sRGB, each 0..1
    bool head = true;                // false: a plain line
    bool outlined = true;            // a light outline, for dark backgrounds
};

struct Dot {
    glm::vec3 position{0.0f};  // world frame, m
    glm::vec3 colour{0.0f};    // sRGB, each 0..1
};

// What is behind everything.
struct Background {
    glm::vec3 colour{0.85f, 0.875f, 0.90f};  // sRGB, each 0 to below 1
    bool haze = true;                        // what is far away fades to it

    bool operator==(const Background&) const = default;
};

// Contents of one frame.
struct Picture {
    Camera camera;
    Background background{};
    glm::vec3 towards_sun{-0.5f, 0.9f, 0.65f};  // world frame, any non-zero length; shadows fall the other way
    std::optional<Ground> ground{};
    std::vector<Body> bodies{};
    std::vector<Bar> bars{};
    std::vector<Panel> panels{};  // in any order; if panels cross, the one farther as a whole is drawn first
    float mark_scale = 1.0f;      // widths of arrows and dots, relative to the default for the image's height, > 0
    std::vector<Arrow> arrows{};  // drawn in order, later ones on top
    std::vector<Dot> dots{};      // likewise, all of them under the arrows
};

// Throws RendererError with the name of the first invalid field: a number that is not finite or out of range, a
// camera or sun without a direction, a panel that is not flat and convex, a polyhedron whose faces do not close.
void check(const Picture& picture);

}  // namespace pushfactor::renderer
