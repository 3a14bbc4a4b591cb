#include "demos/base/text/errors.h"
#include "demos/options/choices.h"
#include "demos/options/simulation_options.h"
#include "demos/runs/build/scene_parts.h"
#include "demos/runs/checkpoint.h"
#include "engine/base/invalid_input.h"
#include "engine/base/overloaded.h"
#include "engine/bodies/diagnostics.h"
#include "engine/forces/gravity.h"
#include "engine/forces/poke.h"

#include <algorithm>
#include <numbers>

namespace pushfactor::demos {

namespace {

using engine::Body;
using engine::Vector3;

// With a mass, of the shape's own moments of inertia.
Body uniform_body(const BodyDescription& described) {
    const double mass = *described.mass;
    const Vector3& position = described.position;
    const engine::Quaternion& orientation = described.orientation;
    return std::visit(
        engine::Overloaded{
            [&](const BoxShape& box) { return engine::box_body(mass, box.size, position, orientation); },
            [&](const SphereShape& sphere) {
                return engine::ball_body(mass, sphere.radius, position, orientation);
            },
            [&](const PlaneShape&) -> Body {
                throw engine::InvalidInput("mass_kg of " + described.name, std::to_string(mass),
                                           "left out: a plane is static");
            },
            [&](const PolyhedronShape& polyhedron) {
                return engine::solid_body(mass, polyhedron.moments, position, orientation);
            }},
        described.shape);
}

Body make_body(const BodyDescription& described) {
    if (!described.mass) return engine::static_body(described.position, described.orientation);
    Body body = described.moments ? engine::solid_body(*described.mass, *described.moments / *described.mass,
                                                       described.position, described.orientation)
                                  : uniform_body(described);
    body.linear_momentum = described.linear_momentum.value_or(described.velocity / body.inverse_mass);
    const engine::Matrix3 inertia = world_inverse_inertia(body).inverse();
    body.angular_momentum = described.angular_momentum.value_or(inertia * described.angular_velocity);
    return body;
}

std::unique_ptr<const engine::Path> make_path(const BodyDescription& described) {
    const engine::Place start{described.position, described.orientation};
    const MotionDescription& motion = *described.motion;
    const engine::PathTimes times{.from = motion.from, .until = motion.until.value_or(engine::infinity)};
    return std::visit(
        engine::Overloaded{
            [&](const SteadyMotion& steady) -> std::unique_ptr<const engine::Path> {
                return std::make_unique<engine::SteadyPath>(
                    start, engine::Motion{steady.velocity, steady.angular_velocity}, times);
            },
            [&](const ShakingMotion& shaking) -> std::unique_ptr<const engine::Path> {
                return std::make_unique<engine::Oscillation>(
                    start, shaking.amplitude * shaking.direction.normalized(), shaking.frequency,
                    shaking.phase * std::numbers::pi / 180.0, times);
            },
            [&](const std::vector<TimedPose>& poses) -> std::unique_ptr<const engine::Path> {
                std::vector<engine::PlaceTable::Entry> entries;
                engine::Place place = start;
                for (const TimedPose& pose : poses) {
                    place = {pose.position.value_or(place.position), pose.orientation.value_or(place.orientation)};
                    entries.push_back({pose.time, place});
                }
                return std::make_unique<engine::PlaceTable>(start, entries);
            }},
        motion.kind);
}

void add_paths(BuiltScene& scene, const SceneDescription& description) {
    for (std::size_t i = 0; i < description.bodies.size(); ++i) {
        const BodyDescription& body = description.bodies[i];
        if (!body.motion) continue;
        if (body.mass) {
            throw engine::InvalidInput("motion of " + body.name, "given", "left out of a body with a mass");
        }
        scene.world.move(static_cast<int>(i), make_path(body));
    }
}

void add_forces(BuiltScene& scene, const SceneDescription& description) {
    if (!description.gravity.isZero()) {
        scene.world.forces.push_back(std::make_unique<engine::Gravity>(description.gravity));
    }
    for (const ForceDescription& force : description.forces) {
        auto source =
            std::make_unique<engine::PokeForce>(engine::Poke{.body = index_of(force.body, description),
                                                             .force = force.force,
                                                             .torque = force.torque,
                                                             .point = force.point,
                                                             .frame = force.frame,
                                                             .from = force.from,
                                                             .until = force.until.value_or(engine::infinity)});
        scene.pokes.push_back(source.get());
        scene.world.forces.push_back(std::move(source));
    }
}

// RATTLE composes steps, which small turns are not smooth enough for.
engine::OrientationStep orientation_step(const Settings& settings) {
    if (settings.rotation == Rotation::paper) return engine::rotate_euler;
    if (settings.rotation == Rotation::exponential) return engine::rotate_exponential;
    return is_rattle(settings.scheme) ? engine::rotate_splitting : engine::rotate_by_small_turns;
}

void add_solver(BuiltScene& scene, const Settings& settings) {
    if (scene.world.constraints.empty()) return;
    scene.world.solver = engine::solvers::make_solver(settings.solver);
    scene.world.termination = {settings.iterations, settings.tolerance_high, settings.tolerance_low};
    if (takes_small_steps(settings)) {
        scene.world.small_steps = std::make_unique<engine::SmallSteps>(settings.small_steps);
    }
}

// RATTLE is for bars alone, and its initial momenta belong to the time of the positions.
void require_bars_alone(const SceneDescription& description, const Settings& settings) {
    const std::string name = scheme_name(settings);
    const auto refuse = [&](const std::string& what) {
        throw engine::InvalidInput("--scheme", name, "auto or whole for a scene with " + what);
    };
    if (description.contacts) refuse("contacts");
    if (!description.joints.empty()) refuse("joints");
    for (const BodyDescription& body : description.bodies) {
        if (body.motion) refuse("moved bodies");
    }
    for (const DistanceDescription& distance : description.distances) {
        if (distance.acts != engine::Distance::Acts::both) refuse("ropes or struts");
        if (distance.max_force) refuse("bars that yield");
        if (distance.spring) refuse("springs");
    }
    if (settings.start_kick == StartKick::on) {
        throw engine::InvalidInput("--start-kick", "on", "off or auto with --scheme " + name);
    }
}

void set_scheme(BuiltScene& scene, const SceneDescription& description, const Settings& settings) {
    if (!is_rattle(settings.scheme)) return;
    require_bars_alone(description, settings);
    scene.step = settings.scheme == Scheme::rattle    ? engine::rattle
                 : settings.scheme == Scheme::rattle4 ? engine::rattle4
                                                      : engine::rattle6;
}

void set_rest(BuiltScene& scene, const Settings& settings) {
    if (!settings.rest || is_rattle(settings.scheme)) return;
    scene.world.rest = std::make_unique<engine::Rest>();
}

void set_threads(BuiltScene& scene, const Settings& settings) {
    const int count = settings.threads == 0 ? engine::Threads::all() : settings.threads;
    if (count > 1) scene.world.threads = std::make_unique<engine::Threads>(count);
}

void set_measure(BuiltScene& scene, const SceneDescription& description, const Settings& settings) {
    if (!description.measure) return;
    const auto momenta = is_rattle(settings.scheme) ? MomentaAt::whole_steps : MomentaAt::half_steps;
    scene.measure = [make = description.measure, momenta](const engine::World& world) {
        return make(world, momenta);
    };
}

// Numbers that are finite may make momenta that are not.
void require_finite(const BuiltScene& scene) {
    const auto found = engine::find_non_finite(scene.world.bodies);
    if (!found) return;
    throw engine::InvalidInput(
        "size, mass and velocity of " + scene.bodies[found->body].name, "together",
        "less extreme, as its " + found->quantity + " is beyond what numbers can be (1e308)");
}

}  // namespace

int index_of(const std::string& name, const SceneDescription& description) {
    const auto& bodies = description.bodies;
    const auto found = std::ranges::find(bodies, name, &BodyDescription::name);
    if (found == bodies.end()) throw engine::InvalidInput("body", name, "the name of a body of the scene");
    return static_cast<int>(found - bodies.begin());
}

BuiltScene build_scene(const SceneDescription& description, const Settings& settings) {
    BuiltScene scene;
    scene.name = description.name;
    scene.gravity = description.gravity;
    scene.bodies = description.bodies;
    scene.view = description.view;
    scene.standing = description.standing;
    for (const BodyDescription& body : description.bodies) scene.world.bodies.push_back(make_body(body));
    require_finite(scene);
    add_paths(scene, description);
    add_forces(scene, description);
    add_distances(scene, description, settings);
    add_joints(scene, description, settings);
    add_contacts(scene, description, settings);
    add_solver(scene, settings);
    scene.world.rotate = orientation_step(settings);
    set_scheme(scene, description, settings);
    set_rest(scene, settings);
    set_threads(scene, settings);
    set_measure(scene, description, settings);
    if (description.state) {
        restore(scene, *description.state);
        scene.parts_before = description.state->parts;
    }
    return scene;
}

BuiltScene build_scene(const Choices& choices) {
    try {
        return build_scene(choices.description, choices.settings);
    } catch (const engine::InvalidInput& error) {
        throw UsageError(choices.scene + ": " + error.what());
    }
}

}  // namespace pushfactor::demos
