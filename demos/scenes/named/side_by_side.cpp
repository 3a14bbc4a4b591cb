#include "demos/scenes/named/side_by_side.h"

#include <algorithm>

namespace pushfactor::demos::scenes {

namespace {

bool same_static_body(const BodyDescription& a, const BodyDescription& b) {
    return !a.mass && !b.mass && a.shape == b.shape && a.position == b.position &&
           a.orientation.coeffs() == b.orientation.coeffs() && a.friction == b.friction &&
           a.restitution == b.restitution && a.surface_velocity == b.surface_velocity &&
           a.surface_from == b.surface_from && a.material == b.material && a.group.empty() && b.group.empty();
}

template <typename Held>
Held renamed(Held held, const std::map<std::string, std::string>& names) {
    for (DistanceDescription::End* end : {&held.a, &held.b}) {
        if (end->body != "world") end->body = names.at(end->body);
    }
    return held;
}

// `prefix` begins the names of what is added.
void add(SceneDescription& all, const SceneDescription& scene, const std::string& prefix) {
    std::map<std::string, std::string> names;  // in the scene, and in all
    const auto before = static_cast<std::ptrdiff_t>(all.bodies.size());
    for (const BodyDescription& body : scene.bodies) {
        const auto end = all.bodies.begin() + before;
        const auto known =
            std::find_if(all.bodies.begin(), end, [&](const auto& other) { return same_static_body(body, other); });
        if (known != end) {
            names[body.name] = known->name;
            continue;
        }
        BodyDescription& added = all.bodies.emplace_back(body);
        added.name = names[body.name] = prefix + body.name;
        if (!body.group.empty()) added.group = prefix + body.group;
    }
    for (const DistanceDescription& distance : scene.distances) all.distances.push_back(renamed(distance, names));
    for (const JointDescription& joint : scene.joints) all.joints.push_back(renamed(joint, names));
    for (ForceDescription force : scene.forces) {
        force.body = names.at(force.body);
        all.forces.push_back(force);
    }
    for (const auto& [a, b] : scene.no_contacts) all.no_contacts.emplace_back(names.at(a), names.at(b));
    // A material is the same in all scenes; the first one to speak of a pair is heard.
    for (const MaterialPairDescription& pair : scene.materials) {
        const bool known = std::any_of(all.materials.begin(), all.materials.end(), [&](const auto& other) {
            return std::minmax(other.a, other.b) == std::minmax(pair.a, pair.b);
        });
        if (!known) all.materials.push_back(pair);
    }
    all.contacts = all.contacts || scene.contacts;
}

}  // namespace

SceneDescription side_by_side(const std::string& name, std::span<const SceneDescription> scenes) {
    SceneDescription all;
    all.name = name;
    if (!scenes.empty()) {
        all.gravity = scenes.front().gravity;
        all.view = scenes.front().view;
        all.has_camera = scenes.front().has_camera;
    }
    for (std::size_t i = 0; i < scenes.size(); ++i) add(all, scenes[i], std::to_string(i + 1) + " ");
    return all;
}

}  // namespace pushfactor::demos::scenes
