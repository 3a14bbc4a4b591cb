// A scene as data: what a scene file says and what the scenes in C++ return. Nothing here acts; build_scene() makes
// the world of it, and what the description does not mention is not constructed.
#pragma once

#include "demos/scenes/polyhedron_shape.h"
#include "engine/base/math.h"
#include "engine/base/overloaded.h"
#include "engine/constraints/distance_constraints.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pushfactor::engine {
class World;
}

namespace pushfactor::demos {

struct BoxShape {
    engine::Vector3 size = engine::Vector3::Ones();  // m, edges
};
struct SphereShape {
    double radius = 0.5;  // m
};
struct PlaneShape {};  // infinite, normal along the body's y axis; static only

struct BodyDescription {
    std::string name{};
    std::variant<BoxShape, SphereShape, PlaneShape, PolyhedronShape> shape{};
    std::optional<double> mass{};                        // kg; static without
    engine::Vector3 position = engine::Vector3::Zero();  // m
    engine::Quaternion orientation = engine::Quaternion::Identity();
    engine::Vector3 velocity = engine::Vector3::Zero();          // m/s, world frame
    engine::Vector3 angular_velocity = engine::Vector3::Zero();  // rad/s, world frame
    // kg m/s and kg m^2/s, world frame, instead of the velocities.
    std::optional<engine::Vector3> linear_momentum{}, angular_momentum{};
    double friction = 0.5;
    double restitution = 0.0;
    engine::Vector3 surface_velocity = engine::Vector3::Zero();  // m/s, body frame: a conveyor
    double surface_from = 0.0;                                   // s, from when on it runs
    std::optional<std::string> colour{};                         // name in the palette
};

// Of a sphere around the body's centre that holds it, m; 0 for a plane, which nothing holds.
inline double bounding_radius(const BodyDescription& body) {
    return std::visit(engine::Overloaded{[](const BoxShape& box) { return 0.5 * box.size.norm(); },
                                         [](const SphereShape& sphere) { return sphere.radius; },
                                         [](const PlaneShape&) { return 0.0; },
                                         [](const PolyhedronShape& polyhedron) { return polyhedron.radius(); }},
                      body.shape);
}

// Gives the body the hull of points [m] in its frame, and moves its frame to the centre of mass and the principal
// axes; velocities stay those of the centre of mass.
void give_polyhedron(BodyDescription& body, const FramedPolyhedron& polyhedron);

struct DistanceDescription {
    struct End {
        std::string body = "world";                       // a body's name, or "world"
        engine::Vector3 point = engine::Vector3::Zero();  // m, body frame (world frame for "world")
    };
    End a{}, b{};
    std::optional<double> length{};  // m; what it is at the start without
    engine::Distance::Acts acts = engine::Distance::Acts::both;
    std::optional<double> max_force{};  // N
};

struct ForceDescription {
    std::string body{};
    engine::Vector3 force = engine::Vector3::Zero();  // N, world frame
    double from = 0.0;                                // s
    std::optional<double> until{};                    // s
};

// Where one looks from, and at what [m]. `floor` is the height of a ground that is drawn and nothing else.
struct View {
    engine::Vector3 eye = engine::Vector3(6, 5, 14);
    engine::Vector3 target = engine::Vector3(0, 1, 0);
    double field_of_view = 38.0;  // degrees, vertical, in [1, 120]
    std::optional<double> floor{};
};

// A scene whose bodies should come to stand one on the other.
struct Standing {
    double side = 0.0;                 // m, edge of a body
    std::vector<double> rest_heights;  // m, of the centres, one a movable body
};

// Where in time the momenta of a run belong: half a step before the positions, as semi-implicit Euler leaves them,
// or with them.
enum class MomentaAt { half_steps, whole_steps };

// What a scene is about, as numbers for the summary; only the scenes in C++ have one.
class SceneMeasure {
  public:
    virtual ~SceneMeasure() = default;
    virtual void observe(const engine::World& world) = 0;  // after each step
    virtual std::vector<std::pair<std::string, double>> result() const = 0;
};

// What a run carries from step to step beside the bodies (run_state.h).
struct RunState;

struct SceneDescription {
    std::string name;
    engine::Vector3 gravity = engine::Vector3(0, -10, 0);  // m/s^2; no force source when zero
    std::vector<BodyDescription> bodies;
    std::vector<DistanceDescription> distances;
    std::vector<ForceDescription> forces;
    bool contacts = false;
    std::shared_ptr<const RunState> state;  // of a run that goes on; none for one that begins
    View view;
    bool has_camera = true;  // false: none is known, and `view` says no more than a direction

    // Simulation options that the scene brings along, before command line and config ("preset" among them).
    std::map<std::string, std::string> options;

    std::optional<Standing> standing;
    std::function<std::unique_ptr<SceneMeasure>(const engine::World&, MomentaAt)> measure;  // may be empty
};

}  // namespace pushfactor::demos
