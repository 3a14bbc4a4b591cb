#include "demos/reports/cost/parts.h"

#include "demos/runs/step_division.h"
#include "engine/forces/poke.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports::cost {

namespace {

std::vector<std::string> forces_of(const engine::World& world) {
    std::vector<std::string> names;
    for (const auto& source : world.forces) {
        names.emplace_back(dynamic_cast<const engine::PokeForce*>(source.get()) ? "poke" : "gravity");
    }
    return names;
}

std::vector<std::string> parts_of(const engine::ContactConstraints& contacts) {
    std::vector<std::string> names;
    if (contacts.friction()) names.emplace_back("friction");
    if (contacts.restitution()) names.emplace_back("restitution");
    if (contacts.continuous_collision()) names.emplace_back("sweep");
    if (contacts.cache()) names.emplace_back("cache");
    return names;
}

}  // namespace

Parts parts_of(const BuiltScene& scene, const Settings& settings) {
    Parts parts;
    parts.forces = forces_of(scene.world);
    if (scene.distances)
        parts.constraints.push_back(fmt::format("{} distances", scene.distances->distances().size()));
    if (scene.contacts) {
        parts.constraints.emplace_back("contacts");
        parts.contacts = parts_of(*scene.contacts);
    }
    if (settings.substeps) return parts;
    for (const StepRule& rule : step_rules(scene)) parts.step_rules.emplace_back(rule.name);
    return parts;
}

}  // namespace pushfactor::demos::reports::cost
