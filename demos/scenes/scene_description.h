// A scene as data, from a scene file or from a scene in C++. build_scene() makes the world of it; parts that the
// description does not mention are absent.
#pragma once

#include "demos/scenes/polyhedron_shape.h"
#include "engine/base/math.h"
#include "engine/base/overloaded.h"
#include "engine/bodies/integrator.h"
#include "engine/constraints/distance_constraints.h"
#include "engine/constraints/joint_constraints.h"
#include "engine/forces/poke.h"

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

namespace elementary = engine::elementary;
using engine::exponential;

struct BoxShape {
    engine::Vector3 size = engine::Vector3::Ones();  // m, edges
    bool operator==(const BoxShape&) const = default;
};
struct SphereShape {
    double radius = 0.5;  // m
    bool operator==(const SphereShape&) const = default;
};
// Infinite, normal along the body's y axis; static only.
struct PlaneShape {
    bool operator==(const PlaneShape&) const = default;
};
using BodyShape = std::variant<BoxShape, SphereShape, PlaneShape, PolyhedronShape>;

// How a body without mass is moved (engine/bodies/path.h), from its own pose on.
struct SteadyMotion {
    engine::Vector3 velocity = engine::Vector3::Zero();          // m/s, world frame
    engine::Vector3 angular_velocity = engine::Vector3::Zero();  // rad/s, world frame, about the body's centre
};
struct ShakingMotion {       // amplitude (sin(2 pi frequency t + phase) - sin(phase)) along the direction
    double amplitude = 0.0;  // m
    engine::Vector3 direction = engine::Vector3::UnitY();  // of any length
    double frequency = 1.0;                                // 1/s
    double phase = 0.0;                                    // degrees; -90 begins at the lowest point
};
struct TimedPose {
    double time = 0.0;                                // s, above 0 and above that of the pose before
    std::optional<engine::Vector3> position{};        // m; as before without
    std::optional<engine::Quaternion> orientation{};  // as before without
};
struct MotionDescription {
    std::variant<SteadyMotion, ShakingMotion, std::vector<TimedPose>> kind{};
    double from = 0.0;              // s; of poses: not used
    std::optional<double> until{};  // s
};

struct BodyDescription {
    std::string name{};
    BodyShape shape{};
    std::optional<double> mass{};  // kg; static without
    // kg m^2, about the axes of the body frame; those of the uniform solid without.
    std::optional<engine::Vector3> moments{};
    std::optional<MotionDescription> motion{};           // of a static body
    engine::Vector3 position = engine::Vector3::Zero();  // m
    engine::Quaternion orientation = engine::Quaternion::Identity();
    engine::Vector3 velocity = engine::Vector3::Zero();          // m/s, world frame
    engine::Vector3 angular_velocity = engine::Vector3::Zero();  // rad/s, world frame
    // kg m/s and kg m^2/s, world frame, instead of the velocities.
    std::optional<engine::Vector3> linear_momentum{}, angular_momentum{};
    double friction = 0.5;
    double restitution = 0.0;
    std::string material{};  // none when empty
    std::string group{};     // whose bodies do not touch each other; none when empty
    engine::Vector3 surface_velocity = engine::Vector3::Zero();  // m/s, body frame: a conveyor
    double surface_from = 0.0;                                   // s, from when on it runs
    std::optional<std::string> colour{};                         // name in the palette
    std::string measured_of{};  // the body whose measured motion this is: it touches nothing (measured_motion.h)
};

// Radius [m] of the bounding sphere around the body's centre; 0 for a plane.
inline double bounding_radius(const BodyDescription& body) {
    return std::visit(engine::Overloaded{[](const BoxShape& box) { return 0.5 * box.size.norm(); },
                                         [](const SphereShape& sphere) { return sphere.radius; },
                                         [](const PlaneShape&) { return 0.0; },
                                         [](const PolyhedronShape& polyhedron) { return polyhedron.radius(); }},
                      body.shape);
}

// Whether it has mass or motion, and a size: what a camera has to follow.
inline bool goes_about(const BodyDescription& body) {
    return body.mass || (body.motion && !std::holds_alternative<PlaneShape>(body.shape));
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
    std::optional<double> length{};  // m; none: the distance at the start
    engine::Distance::Acts acts = engine::Distance::Acts::both;
    std::optional<double> max_force{};       // N
    std::optional<engine::Spring> spring{};  // rigid without
};

struct HingeDescription {
    engine::Vector3 axis = engine::Vector3::UnitZ();  // of any length, frame of a (world frame for "world")
    std::optional<engine::Quaternion> zero{};  // of b in the frame of a at angle 0; that of the start without
    std::optional<engine::Motor> motor{};
    std::optional<engine::AngleLimits> limits{};
};

struct JointDescription {
    DistanceDescription::End a{}, b{};
    std::optional<HingeDescription> hinge{};  // a ball joint without
    bool collide = false;                     // whether the two bodies touch each other
};

struct ForceDescription {
    std::string body{};
    engine::Vector3 force = engine::Vector3::Zero();   // N
    engine::Vector3 torque = engine::Vector3::Zero();  // N m, beside that of the force
    engine::Vector3 point = engine::Vector3::Zero();   // m, body frame: where the force acts
    engine::Poke::Frame frame = engine::Poke::Frame::world;
    double from = 0.0;              // s
    std::optional<double> until{};  // s
};

// What two materials have on each other, instead of what their bodies would.
struct MaterialPairDescription {
    std::string a{}, b{};
    std::optional<double> friction{}, restitution{};
};

// A camera [m]. `floor` is the height of a ground that is only drawn.
struct View {
    engine::Vector3 eye = engine::Vector3(6, 5, 14);
    engine::Vector3 target = engine::Vector3(0, 1, 0);
    double field_of_view = 38.0;  // degrees, vertical, in [1, 120]
    std::optional<double> floor{};
};

// A scene whose bodies should come to stand one on the other.
struct Standing {
    double side = 0.0;                 // m, edge of a body
    std::vector<double> rest_heights;  // m, of the centres, one per movable body
};

// Time of the momenta: half a step before the positions, as in semi-implicit Euler, or the same.
enum class MomentaAt { half_steps, whole_steps };

// A scene's own measures for the summary; only scenes in C++ have them.
class SceneMeasure {
  public:
    virtual ~SceneMeasure() = default;
    virtual void observe(const engine::World& world) = 0;  // after each step
    virtual std::vector<std::pair<std::string, double>> result() const = 0;
    // Whether it takes as long as the steps, and so is only made when asked for.
    virtual bool is_costly() const { return false; }
};

// State of a run besides the bodies (run_state.h).
struct RunState;

struct SceneDescription {
    std::string name;
    engine::Vector3 gravity = engine::Vector3(0, -10, 0);  // m/s^2; no force source when zero
    std::vector<BodyDescription> bodies;
    std::vector<DistanceDescription> distances;
    std::vector<JointDescription> joints;
    std::vector<ForceDescription> forces;
    bool contacts = false;
    std::vector<std::pair<std::string, std::string>> no_contacts;  // bodies that do not touch each other
    std::vector<MaterialPairDescription> materials;
    std::shared_ptr<const RunState> state;  // of a resumed run, else null
    View view;
    bool has_camera = true;  // false: `view` gives only a direction

    // Simulation options of the scene, overridden by command line and config ("preset" among them).
    std::map<std::string, std::string> options;

    std::optional<Standing> standing;
    std::function<std::unique_ptr<SceneMeasure>(const engine::World&, MomentaAt)> measure;  // may be empty
};

}  // namespace pushfactor::demos
