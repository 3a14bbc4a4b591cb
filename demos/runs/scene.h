// A scene: a world of the parts that it needs, and what one has to know to look at it. Engine types only, so that
// tests and reports use the same scenes as the program.
#pragma once

#include "demos/options/settings.h"
#include "demos/scenes/scene_description.h"
#include "engine/constraints/contact_constraints.h"
#include "engine/rattle.h"
#include "engine/world.h"

#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos {

struct Choices;

struct BuiltScene {
    std::string name;
    engine::World world;
    engine::StepMethod step = [](engine::World& w, double dt) { return w.step(dt); };  // the paper's
    engine::Vector3 gravity = engine::Vector3(0, -10, 0);    // m/s^2, what the world's force source applies
    const engine::ContactConstraints* contacts = nullptr;    // part of the world; null when bodies never touch
    const engine::DistanceConstraints* distances = nullptr;  // part of the world; null without distances
    const engine::JointConstraints* joints = nullptr;        // part of the world; null without joints

    std::optional<double> substeps_before{};  // when it goes on: StepDivision::level()

    std::vector<BodyDescription> bodies;  // as described, in the order of the world's first bodies
    View view;
    std::optional<Standing> standing;
    std::function<std::unique_ptr<SceneMeasure>(const engine::World&)> measure;
};

// The world of a description under the settings. What either leaves out is not constructed. When distances or
// joints hang on "world", a static body for it comes last. Throws engine::InvalidInput for a name that no body has,
// for an scheme that does not fit the scene, and for what the engine refuses.
BuiltScene build_scene(const SceneDescription& description, const Settings& settings);
// Of a run.
BuiltScene build_scene(const Choices& choices);

}  // namespace pushfactor::demos
