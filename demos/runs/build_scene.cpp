#include "demos/options/choices.h"
#include "demos/options/simulation_options.h"
#include "demos/runs/scene.h"
#include "demos/scenes/run_state.h"
#include "engine/base/invalid_input.h"
#include "engine/base/overloaded.h"
#include "engine/bodies/diagnostics.h"
#include "engine/forces/gravity.h"
#include "engine/forces/poke.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace pushfactor::demos {

namespace {

using engine::Body;
using engine::Vector3;
namespace collision = engine::collision;

Body make_body(const BodyDescription& described) {
    const auto& orientation = described.orientation;
    if (!described.mass) return engine::static_body(described.position, orientation);

    Body body = std::visit(
        engine::Overloaded{
            [&](const BoxShape& box) {
                return engine::box_body(*described.mass, box.size, described.position, orientation);
            },
            [&](const SphereShape& sphere) {
                return engine::ball_body(*described.mass, sphere.radius, described.position, orientation);
            },
            [&](const PlaneShape&) -> Body {
                throw engine::InvalidInput("mass_kg of " + described.name, std::to_string(*described.mass),
                                           "left out: a plane is static");
            },
            [&](const PolyhedronShape& polyhedron) {
                return engine::solid_body(*described.mass, polyhedron.moments, described.position, orientation);
            }},
        described.shape);
    body.linear_momentum = described.linear_momentum.value_or(described.velocity / body.inverse_mass);
    const engine::Matrix3 inertia = world_inverse_inertia(body).inverse();
    body.angular_momentum = described.angular_momentum.value_or(inertia * described.angular_velocity);
    return body;
}

std::unique_ptr<const engine::Path> make_path(const BodyDescription& described) {
    engine::Place start{described.position, described.orientation};
    const MotionDescription& motion = *described.motion;
    engine::PathTimes times{.from = motion.from};
    if (motion.until) times.until = *motion.until;
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

collision::Shape make_shape(const BodyDescription& described) {
    return std::visit(
        engine::Overloaded{
            [](const BoxShape& box) -> collision::Shape { return collision::Box{0.5 * box.size}; },
            [](const SphereShape& sphere) -> collision::Shape { return collision::Sphere{sphere.radius}; },
            [](const PlaneShape&) -> collision::Shape { return collision::Plane{}; },
            [](const PolyhedronShape& polyhedron) -> collision::Shape {
                return collision::Polyhedron{polyhedron.mesh};
            }},
        described.shape);
}

int index_of(const std::string& name, const SceneDescription& description) {
    const auto& bodies = description.bodies;
    const auto found =
        std::find_if(bodies.begin(), bodies.end(), [&](const auto& body) { return body.name == name; });
    if (found == bodies.end()) throw engine::InvalidInput("body", name, "the name of a body of the scene");
    return static_cast<int>(found - bodies.begin());
}

void add_forces(BuiltScene& scene, const SceneDescription& description) {
    if (!description.gravity.isZero()) {
        scene.world.forces.push_back(std::make_unique<engine::Gravity>(description.gravity));
    }
    for (const ForceDescription& force : description.forces) {
        engine::Poke poke{.body = index_of(force.body, description),
                          .force = force.force,
                          .torque = force.torque,
                          .point = force.point,
                          .frame = force.frame,
                          .from = force.from};
        if (force.until) poke.until = *force.until;
        scene.world.forces.push_back(std::make_unique<engine::PokeForce>(poke));
    }
}

// Index of the static body that represents the world; created on first use.
int world_body(BuiltScene& scene, std::optional<int>& known) {
    if (!known) {
        known = static_cast<int>(scene.world.bodies.size());
        scene.world.bodies.push_back(engine::static_body(Vector3::Zero()));
    }
    return *known;
}

// Without a length it is what it is at the start, and a ball joint where the points are meant to be one: a number
// with six digits misses by a millionth of the lever.
double length_of(const DistanceDescription& described, const engine::Distance& distance,
                 std::span<const Body> bodies) {
    if (described.length) return *described.length;
    const auto [from, to] = span_of(distance, bodies);
    double levers = 0.0;
    for (const auto& [body, point] :
         {std::pair{distance.body_a, distance.point_a}, {distance.body_b, distance.point_b}}) {
        if (!bodies[static_cast<std::size_t>(body)].is_static()) levers += point.norm();
    }
    const double length = (to - from).norm();
    return length <= 1e-6 * levers + 1e-15 * (from.norm() + to.norm()) ? 0.0 : length;
}

// Length 0 has no direction to pull, push or limit a force along.
void require_joint_without_bounds(const DistanceDescription& described) {
    if (described.spring) {
        throw engine::InvalidInput("length of the spring between " + described.a.body + " and " + described.b.body,
                                   "0", "above 0, as a spring of no length has no direction");
    }
    if (described.acts == engine::Distance::Acts::both && !described.max_force) return;
    throw engine::InvalidInput("length of the distance between " + described.a.body + " and " + described.b.body,
                               "0", "above 0, or it is a ball joint, which acts both ways and without max_force_n");
}

// Sets bodies and points of a distance or a joint; at least one of the bodies must be movable.
template <typename Described, typename Held>
void join(BuiltScene& scene, const SceneDescription& description, const Described& described, const char* what,
          std::optional<int>& world, Held& held) {
    const auto body_index = [&](const std::string& name) {
        return name == "world" ? world_body(scene, world) : index_of(name, description);
    };
    held.body_a = body_index(described.a.body);
    held.body_b = body_index(described.b.body);
    held.point_a = described.a.point;
    held.point_b = described.b.point;
    const auto is_static = [&](int body) { return scene.world.bodies[static_cast<std::size_t>(body)].is_static(); };
    if (!is_static(held.body_a) || !is_static(held.body_b)) return;
    throw engine::InvalidInput(std::string(what) + " between " + described.a.body + " and", described.b.body,
                               "a movable body, as the other one is static");
}

void add_distances(BuiltScene& scene, const SceneDescription& description, const Settings& settings,
                   std::optional<int>& world) {
    if (description.distances.empty()) return;
    std::vector<engine::Distance> distances;
    for (const DistanceDescription& described : description.distances) {
        engine::Distance distance;
        join(scene, description, described, "distance", world, distance);
        distance.length = length_of(described, distance, scene.world.bodies);
        if (!std::isfinite(distance.length)) {
            throw engine::InvalidInput(
                "length of the distance between " + described.a.body + " and " + described.b.body, "beyond 1e308",
                "finite");
        }
        if (is_ball_joint(distance)) require_joint_without_bounds(described);
        distance.acts = described.acts;
        if (described.max_force) distance.max_force = *described.max_force;
        distance.spring = described.spring;
        distances.push_back(distance);
    }
    const engine::Correction whole{engine::PushKind::persistent, 1.0};
    auto source = std::make_unique<engine::DistanceConstraints>(
        std::move(distances), is_rattle(settings.scheme) ? whole : settings.distances, settings.warm_start);
    if (description.state) source->set_forces(description.state->distance_forces);
    scene.distances = source.get();
    scene.world.constraints.push_back(std::move(source));
}

engine::Hinge make_hinge(const HingeDescription& described, const Body& a, const Body& b) {
    return {.axis = described.axis.normalized(),
            .zero = described.zero.value_or(a.orientation.conjugate() * b.orientation),
            .motor = described.motor,
            .limits = described.limits};
}

void add_joints(BuiltScene& scene, const SceneDescription& description, const Settings& settings,
                std::optional<int>& world) {
    if (description.joints.empty()) return;
    std::vector<engine::Joint> joints;
    for (const JointDescription& described : description.joints) {
        engine::Joint& joint = joints.emplace_back();
        join(scene, description, described, "joint", world, joint);
        if (!described.hinge) continue;
        const auto& bodies = scene.world.bodies;
        joint.hinge = make_hinge(*described.hinge, bodies[static_cast<std::size_t>(joint.body_a)],
                                 bodies[static_cast<std::size_t>(joint.body_b)]);
    }
    auto source =
        std::make_unique<engine::JointConstraints>(std::move(joints), settings.distances, settings.warm_start);
    if (description.state) source->set_forces(description.state->joint_forces);
    scene.joints = source.get();
    scene.world.constraints.push_back(std::move(source));
}

std::unique_ptr<engine::FrictionRule> make_friction(FrictionModel model, const Vector3& gravity) {
    switch (model) {
        case FrictionModel::cone:
            return std::make_unique<engine::ConeFriction>();
        case FrictionModel::coulomb:
            return std::make_unique<engine::CoulombFriction>();
        case FrictionModel::paper:
            break;
    }
    return std::make_unique<engine::WeightFriction>(gravity);
}

engine::RestitutionRule restitution_rule(RestitutionModel model) {
    return model == RestitutionModel::sum ? engine::restitution_sum : engine::restitution_larger;
}

// The numbers of what the bodies name, by body and by name: groups or materials. Negative without a name.
struct Numbers {
    Numbers(const SceneDescription& description, std::string BodyDescription::*what) {
        for (const BodyDescription& body : description.bodies) {
            const std::string& name = body.*what;
            of_bodies.push_back(name.empty() ? -1 : by_name.emplace(name, by_name.size()).first->second);
        }
    }
    std::vector<int> of_bodies;
    std::map<std::string, int> by_name;
};

std::unique_ptr<collision::PairFilter> make_filter(const SceneDescription& description) {
    const Numbers groups(description, &BodyDescription::group);
    std::vector<collision::Pair> pairs;
    for (const auto& [a, b] : description.no_contacts) {
        pairs.push_back({index_of(a, description), index_of(b, description)});
    }
    for (const JointDescription& joint : description.joints) {
        if (joint.collide || joint.a.body == "world" || joint.b.body == "world") continue;
        pairs.push_back({index_of(joint.a.body, description), index_of(joint.b.body, description)});
    }
    if (groups.by_name.empty() && pairs.empty()) return nullptr;
    return std::make_unique<collision::PairFilter>(groups.by_name.empty() ? std::vector<int>() : groups.of_bodies,
                                                   std::move(pairs));
}

// The options --friction and --restitution are for all pairs.
std::unique_ptr<collision::MaterialPairs> make_materials(const SceneDescription& description,
                                                         const Settings& settings) {
    if (description.materials.empty()) return nullptr;
    const auto numbers = Numbers(description, &BodyDescription::material).by_name;
    auto materials = std::make_unique<collision::MaterialPairs>(static_cast<int>(numbers.size()));
    const auto number_of = [&](const std::string& name) {
        const auto found = numbers.find(name);
        if (found == numbers.end()) throw engine::InvalidInput("material", name, "the material of a body");
        return found->second;
    };
    for (const MaterialPairDescription& pair : description.materials) {
        collision::MaterialPairs::Surface surface;
        if (!settings.friction) surface.friction = pair.friction;
        if (!settings.restitution) surface.restitution = pair.restitution;
        materials->set(number_of(pair.a), number_of(pair.b), surface);
    }
    return materials;
}

std::vector<collision::Collider> make_colliders(const SceneDescription& description, const Settings& settings) {
    const Numbers materials(description, &BodyDescription::material);
    std::vector<collision::Collider> colliders;
    for (int i = 0; i < static_cast<int>(description.bodies.size()); ++i) {
        const BodyDescription& body = description.bodies[static_cast<std::size_t>(i)];
        colliders.push_back({.body = i,
                             .shape = make_shape(body),
                             .friction = settings.friction.value_or(body.friction),
                             .restitution = settings.restitution.value_or(body.restitution),
                             .surface_velocity = body.surface_velocity,
                             .surface_from = body.surface_from,
                             .material = materials.of_bodies[static_cast<std::size_t>(i)]});
    }
    return colliders;
}

void add_contacts(BuiltScene& scene, const SceneDescription& description, const Settings& settings) {
    if (!description.contacts) return;
    const std::vector<collision::Collider> colliders = make_colliders(description, settings);
    const auto any = [&](double collision::Collider::*what) {
        return std::any_of(colliders.begin(), colliders.end(), [what](const auto& c) { return c.*what > 0.0; });
    };
    const engine::ContactChoices choices{
        .correction = settings.contacts,
        .slop = settings.slop,
        .detection = {.margin = settings.margin, .reduce_to_four_points = settings.four_points},
        .order = settings.row_order,
    };
    auto contacts = std::make_unique<engine::ContactConstraints>(colliders, choices);
    auto materials = make_materials(description, settings);
    if (any(&collision::Collider::friction) || (materials && materials->any_friction())) {
        contacts->set_friction(make_friction(settings.friction_model, scene.gravity));
    }
    if (any(&collision::Collider::restitution) || (materials && materials->any_bounces())) {
        contacts->set_restitution(restitution_rule(settings.restitution_model));
    }
    if (settings.margin > 0.0)
        contacts->set_continuous_collision(std::make_unique<collision::ContinuousCollision>());
    if (settings.warm_start) {
        contacts->set_cache(std::make_unique<engine::ContactCache>(
            description.state ? description.state->contact_forces : engine::ContactCache{}));
    }
    contacts->set_materials(std::move(materials));
    contacts->set_filter(make_filter(description));
    scene.contacts = contacts.get();
    scene.world.constraints.push_back(std::move(contacts));
}

// Bodies with contacts rotate by small turns, without them by splitting, which then keeps its order.
engine::OrientationStep orientation_step(Rotation rotation, bool contacts) {
    switch (rotation) {
        case Rotation::paper:
            return engine::rotate_euler;
        case Rotation::exponential:
            return engine::rotate_exponential;
        case Rotation::splitting:
            break;
    }
    return contacts ? engine::rotate_by_small_turns : engine::rotate_splitting;
}

// With a fixed number of iterations or another solver than auto, steps stay whole.
bool takes_small_steps(const Settings& settings) {
    if (settings.scheme == Scheme::small_steps) return true;
    return settings.scheme == Scheme::automatic && settings.solver == "auto" && settings.tolerance_high > 0.0;
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

void set_rest(BuiltScene& scene, const SceneDescription& description, const Settings& settings) {
    if (!settings.rest) return;
    if (is_rattle(settings.scheme)) {
        throw engine::InvalidInput("--rest", "on", "off with --scheme " + scheme_name(settings));
    }
    scene.world.rest = std::make_unique<engine::Rest>();
    if (description.state) scene.world.rest->set_memory(description.state->rest, scene.world.bodies);
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

// Velocities that are finite may make momenta that are not.
void require_finite(const BuiltScene& scene) {
    const auto found = engine::find_non_finite(scene.world.bodies);
    if (!found) return;
    throw engine::InvalidInput(found->quantity + " of " + scene.bodies[found->body].name, "beyond 1e308", "finite");
}

void resume(BuiltScene& scene, const RunState& state) {
    scene.world.resume(state.time, state.warm_start);
    scene.substeps_before = state.substeps;
}

}  // namespace

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
    std::optional<int> world;
    add_distances(scene, description, settings, world);
    add_joints(scene, description, settings, world);
    add_contacts(scene, description, settings);
    add_solver(scene, settings);
    scene.world.rotate = orientation_step(settings.rotation, description.contacts);
    set_scheme(scene, description, settings);
    set_rest(scene, description, settings);
    set_threads(scene, settings);
    set_measure(scene, description, settings);
    if (description.state) resume(scene, *description.state);
    return scene;
}

BuiltScene build_scene(const Choices& choices) {
    return build_scene(choices.description, choices.settings);
}

}  // namespace pushfactor::demos
