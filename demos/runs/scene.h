// A built scene: a world of the parts that it needs, and its view. Engine types only, so that tests and reports use
// the same scenes as the program.
#pragma once

#include "demos/options/settings.h"
#include "demos/scenes/scene_description.h"
#include "engine/constraints/contact_constraints.h"
#include "engine/forces/poke.h"
#include "engine/rattle.h"
#include "engine/world.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos {

struct Choices;

struct BuiltScene {
    std::string name;
    engine::World world;
    engine::StepMethod step = [](engine::World& w, double dt) { return w.step(dt); };  // the paper's
    engine::Vector3 gravity = engine::Vector3(0, -10, 0);  // m/s^2, what the world's force source applies
    engine::ContactConstraints* contacts = nullptr;        // part of the world; null when bodies never touch
    engine::DistanceConstraints* distances = nullptr;      // part of the world; null without distances
    engine::JointConstraints* joints = nullptr;            // part of the world; null without joints
    std::vector<const engine::PokeForce*> pokes;           // part of the world: forces on single bodies
    std::vector<engine::collision::Pair> no_contacts;  // bodies that do not touch, beside those of groups (a < b)

    std::optional<double> parts_before{};  // of a resumed run

    std::vector<BodyDescription> bodies;  // as described, in the order of the world's first bodies
    View view;
    std::optional<Standing> standing;
    std::function<std::unique_ptr<SceneMeasure>(const engine::World&)> measure;
};

// Calls `visit` with each distance and each joint of the scene.
template <typename Visit>
void each_held(const BuiltScene& scene, const Visit& visit) {
    if (scene.distances) std::ranges::for_each(scene.distances->distances(), visit);
    if (scene.joints) std::ranges::for_each(scene.joints->joints(), visit);
}

// Builds the world of a description under the settings; parts that either leaves out are absent. If distances or
// joints hang on "world", the last body is a static one for it. Throws engine::InvalidInput for an unknown body
// name, for a scheme that does not fit the scene, and for what the engine refuses.
BuiltScene build_scene(const SceneDescription& description, const Settings& settings);
// The same for the options of a run.
BuiltScene build_scene(const Choices& choices);

}  // namespace pushfactor::demos
