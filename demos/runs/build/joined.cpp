#include "demos/runs/build/scene_parts.h"
#include "engine/base/invalid_input.h"
#include "engine/system/loops.h"

#include <cmath>

namespace pushfactor::demos {

namespace {

using engine::Body;
using engine::Vector3;

// The static body for what hangs on "world": the one after those of the scene, added when it is needed first.
int index_of_world(BuiltScene& scene) {
    const std::size_t described = scene.bodies.size();
    if (scene.world.bodies.size() == described) scene.world.bodies.push_back(engine::static_body(Vector3::Zero()));
    return static_cast<int>(described);
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
void require_length(const DistanceDescription& described, const engine::Distance& distance) {
    const auto refuse = [&](const std::string& what, const char* length, const char* allowed) {
        throw engine::InvalidInput(
            "length of the " + what + " between " + described.a.body + " and " + described.b.body, length, allowed);
    };
    if (!std::isfinite(distance.length)) refuse("distance", "beyond 1e308", "finite");
    if (!is_ball_joint(distance)) return;
    if (described.spring) refuse("spring", "0", "above 0, as a spring of no length has no direction");
    if (described.acts != engine::Distance::Acts::both || described.max_force) {
        refuse("distance", "0", "above 0, or it is a ball joint, which acts both ways and without max_force_n");
    }
}

// Sets bodies and points of a distance or a joint; at least one of the bodies must be movable.
template <typename Described, typename Held>
void join(BuiltScene& scene, const SceneDescription& description, const Described& described, const char* what,
          Held& held) {
    const auto body_index = [&](const std::string& name) {
        return name == "world" ? index_of_world(scene) : index_of(name, description);
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

engine::Hinge make_hinge(const HingeDescription& described, const Body& a, const Body& b) {
    return {.axis = described.axis.normalized(),
            .zero = described.zero.value_or(a.orientation.conjugate() * b.orientation),
            .motor = described.motor,
            .limits = described.limits};
}

// Static bodies are node 0. Springs give way by themselves, and hold nothing together.
std::vector<std::pair<int, int>> connections(const BuiltScene& scene, std::span<const engine::Joint> joints) {
    std::vector<std::pair<int, int>> edges;
    const std::span<const Body> bodies = scene.world.bodies;
    const auto node = [&](int body) { return bodies[static_cast<std::size_t>(body)].is_static() ? 0 : body + 1; };
    for (const engine::Joint& joint : joints) edges.emplace_back(node(joint.body_a), node(joint.body_b));
    if (scene.distances) {
        for (const engine::Distance& distance : scene.distances->distances()) {
            if (!distance.spring) edges.emplace_back(node(distance.body_a), node(distance.body_b));
        }
    }
    return edges;
}

void find_loops(const BuiltScene& scene, std::vector<engine::Joint>& joints) {
    const auto edges = connections(scene, joints);
    const std::vector<char> loops = engine::on_loops(edges, static_cast<int>(scene.world.bodies.size()) + 1);
    for (std::size_t k = 0; k < joints.size(); ++k) joints[k].closes_loop = loops[k] != 0;
}

}  // namespace

void add_distances(BuiltScene& scene, const SceneDescription& description, const Settings& settings) {
    if (description.distances.empty()) return;
    std::vector<engine::Distance> distances;
    for (const DistanceDescription& described : description.distances) {
        engine::Distance distance;
        join(scene, description, described, "distance", distance);
        distance.length = length_of(described, distance, scene.world.bodies);
        require_length(described, distance);
        distance.acts = described.acts;
        distance.max_force = described.max_force.value_or(engine::infinity);
        distance.spring = described.spring;
        distances.push_back(distance);
    }
    const engine::Correction whole{engine::PushKind::persistent, 1.0};
    auto source = std::make_unique<engine::DistanceConstraints>(
        std::move(distances), is_rattle(settings.scheme) ? whole : settings.distances, settings.warm_start);
    scene.distances = source.get();
    scene.world.constraints.push_back(std::move(source));
}

void add_joints(BuiltScene& scene, const SceneDescription& description, const Settings& settings) {
    if (description.joints.empty()) return;
    std::vector<engine::Joint> joints;
    for (const JointDescription& described : description.joints) {
        engine::Joint& joint = joints.emplace_back();
        join(scene, description, described, "joint", joint);
        if (!described.hinge) continue;
        const auto& bodies = scene.world.bodies;
        joint.hinge = make_hinge(*described.hinge, bodies[static_cast<std::size_t>(joint.body_a)],
                                 bodies[static_cast<std::size_t>(joint.body_b)]);
    }
    find_loops(scene, joints);
    auto source =
        std::make_unique<engine::JointConstraints>(std::move(joints), settings.distances, settings.warm_start);
    scene.joints = source.get();
    scene.world.constraints.push_back(std::move(source));
}

std::vector<int> mechanisms_of(const BuiltScene& scene) {
    if (!scene.joints) return {};
    auto edges = connections(scene, scene.joints->joints());
    std::erase_if(edges, [](const auto& edge) { return edge.first == 0 || edge.second == 0; });
    std::vector<int> of_bodies = engine::connected(edges, static_cast<int>(scene.world.bodies.size()) + 1);
    of_bodies.erase(of_bodies.begin());
    return of_bodies;
}

}  // namespace pushfactor::demos
