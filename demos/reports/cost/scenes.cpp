#include "demos/reports/cost/cost.h"
#include "demos/runs/step_division.h"
#include "demos/scenes/catalogue.h"
#include "engine/forces/poke.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace pushfactor::demos::reports::cost {

namespace {

constexpr double settled = 10.0, falling = 1.0;  // s
constexpr double no_force = 1e-12;               // N
constexpr double next_to_nothing = 1e-9;

struct Size {
    const char *name, *scene;
    OptionTexts options;
    bool large = false;
};

const std::vector<Size> sizes{
    {"stack of 20, touching", "stack", {{"count", "20"}, {"gap", "0"}}},
    {"stack of 40, touching, jittered", "stack", {{"count", "40"}, {"gap", "0"}, {"jitter", "0.01"}}, true},
    {"funnel of 200", "funnel", {{"count", "200"}}},
    {"funnel of 2000", "funnel", {{"count", "2000"}}, true},
};

// A bar that yields at once: it never has its length, and so needs a correction in every step.
DistanceDescription yielding_bar(const BodyDescription& body) {
    DistanceDescription bar;
    bar.a.point = body.position + engine::Vector3(0, 2, 0);
    bar.b.body = body.name;
    bar.length = 1.0;
    bar.max_force = no_force;
    return bar;
}

}  // namespace

std::vector<CostCase> cost_cases(bool quick) {
    std::vector<CostCase> cases;
    const auto add = [&cases](const std::string& name, const std::string& scene, const OptionTexts& options) {
        cases.push_back({name, scene, options, settled});
        if (scene == "funnel") cases.push_back({name + ", falling", scene, options, falling});
    };
    for (const SceneEntry& scene : catalogue()) {
        add(std::string(scene.name), std::string(scene.name), {});
        for (const Size& size : sizes) {
            if (scene.name == size.scene && !(quick && size.large)) add(size.name, size.scene, size.options);
        }
    }
    return cases;
}

SceneDescription with_everything(SceneDescription scene) {
    const auto body = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                   [](const BodyDescription& each) { return each.mass.has_value(); });
    if (body == scene.bodies.end()) throw std::logic_error("a scene in which nothing moves");
    scene.forces.push_back({.body = body->name, .force = engine::Vector3(0, -no_force, 0)});
    if (scene.distances.empty()) scene.distances.push_back(yielding_bar(*body));
    scene.contacts = true;
    for (BodyDescription& each : scene.bodies) {
        each.friction = std::max(each.friction, next_to_nothing);
        each.restitution = std::max(each.restitution, next_to_nothing);
    }
    for (const char* const push : {"push", "distance-push"}) scene.options[push] = "single-frame";
    scene.options["substeps"] = "auto";
    return scene;
}

Parts parts_of(const BuiltScene& scene, const Settings& settings) {
    Parts parts;
    for (const auto& source : scene.world.forces) {
        parts.forces.emplace_back(dynamic_cast<const engine::PokeForce*>(source.get()) ? "poke" : "gravity");
    }
    if (scene.distances)
        parts.constraints.push_back(fmt::format("{} distances", scene.distances->distances().size()));
    if (scene.joints) parts.constraints.push_back(fmt::format("{} joints", scene.joints->joints().size()));
    if (scene.contacts) {
        parts.constraints.emplace_back("contacts");
        if (scene.contacts->friction()) parts.contacts.emplace_back("friction");
        if (scene.contacts->restitution() || scene.world.impacts) parts.contacts.emplace_back("restitution");
        if (scene.contacts->materials()) parts.contacts.emplace_back("materials");
        if (scene.contacts->filter()) parts.contacts.emplace_back("pairs left out");
        if (scene.contacts->continuous_collision()) parts.contacts.emplace_back("sweep");
        if (scene.contacts->cache()) parts.contacts.emplace_back("cache");
    }
    if (settings.substeps) return parts;
    for (const StepRule& rule : step_rules(scene)) parts.step_rules.emplace_back(rule.name);
    return parts;
}

}  // namespace pushfactor::demos::reports::cost
