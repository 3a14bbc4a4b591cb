#include "demos/reports/cost/everything.h"

#include <algorithm>
#include <stdexcept>

namespace pushfactor::demos::reports::cost {

namespace {

constexpr double no_force = 1e-12;  // N
constexpr double next_to_nothing = 1e-9;

const BodyDescription& first_movable(const SceneDescription& scene) {
    const auto found = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                    [](const BodyDescription& body) { return body.mass.has_value(); });
    if (found == scene.bodies.end()) throw std::logic_error("a scene in which nothing moves");
    return *found;
}

// A bar that yields at once: it is never as long as it should be, and so asks for a correction in every step.
DistanceDescription yielding_bar(const BodyDescription& body) {
    DistanceDescription bar;
    bar.a.point = body.position + engine::Vector3(0, 2, 0);
    bar.b.body = body.name;
    bar.length = 1.0;
    bar.max_force = no_force;
    return bar;
}

}  // namespace

SceneDescription with_everything(SceneDescription scene) {
    const BodyDescription& body = first_movable(scene);
    scene.forces.push_back({.body = body.name, .force = engine::Vector3(0, -no_force, 0)});
    if (scene.distances.empty()) scene.distances.push_back(yielding_bar(body));
    scene.contacts = true;
    for (BodyDescription& each : scene.bodies) {
        each.friction = std::max(each.friction, next_to_nothing);
        each.restitution = std::max(each.restitution, next_to_nothing);
    }
    scene.options["push"] = "single-frame";
    scene.options["distance-push"] = "single-frame";
    scene.options["substeps"] = "auto";
    return scene;
}

}  // namespace pushfactor::demos::reports::cost
