#include "tests/fuzz/judge.h"

#include "demos/base/text/errors.h"
#include "demos/runs/simulation.h"
#include "engine/impacts/impacts.h"
#include "tests/fuzz/random_scene.h"
#include "tests/fuzz/step_claims.h"

#include <algorithm>

namespace pushfactor::tests {

namespace {

bool is_isolated(const demos::SceneDescription& scene) {
    const auto touches_world = [](const auto& d) { return d.a.body == "world" || d.b.body == "world"; };
    return scene.gravity.isZero(0.0) && scene.forces.empty() &&
           std::none_of(scene.distances.begin(), scene.distances.end(), touches_world) &&
           std::none_of(scene.joints.begin(), scene.joints.end(), touches_world) &&
           std::all_of(scene.bodies.begin(), scene.bodies.end(), [](const auto& body) { return body.mass; });
}

// Corrections for one frame do so, and bounces within a step: the body is not where its final velocity would have
// taken it.
bool moves_without_momentum(const demos::SceneDescription& scene, const demos::Settings& settings) {
    return settings.contacts.kind == engine::PushKind::single_frame ||
           settings.distances.kind == engine::PushKind::single_frame ||
           std::any_of(scene.bodies.begin(), scene.bodies.end(),
                       [](const auto& body) { return body.restitution > 0.0; }) ||
           std::any_of(scene.materials.begin(), scene.materials.end(),
                       [](const auto& pair) { return pair.restitution.value_or(0.0) > 0.0; });
}

// Sweeps row by row lower q with every row while the bounds are numbers; over-relaxed or conjugate ones need not.
bool lowers_its_objective(const demos::Settings& settings, const engine::World& world) {
    const bool follow = std::any_of(world.rows().begin(), world.rows().end(),
                                    [](const engine::ConstraintRow& row) { return row.bounds.of_row >= 0; });
    return settings.solver != "jacobi" && settings.solver != "nncg" && !follow;
}

// Its bodies have moved with the means of the small steps.
bool any_small_steps(const engine::World& world) {
    const auto islands = world.islands().all();
    return std::any_of(islands.begin(), islands.end(), [&](const auto& island) {
        return world.outcome_of(island).method == engine::IslandSolver::Method::in_small_steps;
    });
}

bool any_swept(const demos::BuiltScene& scene) {
    if (!scene.contacts) return false;
    if (scene.world.impacts && !scene.world.impacts->followed().empty()) return true;
    const std::vector<engine::ContactSite> sites = scene.contacts->sites();
    return std::any_of(sites.begin(), sites.end(), [](const auto& site) { return site.swept; });
}

Verdict run(const demos::SceneDescription& scene) {
    const demos::Settings settings = settings_of(scene);
    demos::Simulation simulation(build_scene(scene, settings), settings);
    const engine::World& world = simulation.scene().world;
    const bool isolated = is_isolated(scene), shifts = moves_without_momentum(scene, settings);
    for (long step = 1; step <= whole_steps(settings); ++step) {
        const std::vector<engine::Body> before = world.bodies;
        const demos::Sample& sample = simulation.advance();
        const auto broken = sample.substeps == 1 ? broken_claim({.before = before,
                                                                 .world = world,
                                                                 .isolated = isolated,
                                                                 .shifts = shifts || any_small_steps(world),
                                                                 .swept = any_swept(simulation.scene()),
                                                                 .monotone = lowers_its_objective(settings, world)})
                                                 : broken_bounds(world);
        if (broken) return {Verdict::Kind::fails, broken->claim, broken->what, step};
    }
    return {};
}

}  // namespace

Verdict judge(const demos::SceneDescription& scene) {
    try {
        return run(scene);
    } catch (const demos::NonFiniteError& error) {
        return {Verdict::Kind::non_finite, "finite", error.what()};
    } catch (const std::exception& error) {
        return {Verdict::Kind::fails, "accepted", error.what()};
    }
}

}  // namespace pushfactor::tests
