#include "tests/fuzz/sleepers.h"

#include "demos/runs/simulation.h"
#include "tests/fuzz/random_scene.h"
#include "tests/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pushfactor::tests {

namespace {

using demos::Simulation;
using engine::Body;

constexpr double watched = 10.0, latest = 6.0;  // s; after the family's time of rest

Simulation start(const demos::SceneDescription& scene) {
    const demos::Settings settings = settings_of(scene);
    return Simulation(build_scene(scene, settings), settings);
}

void advance(Simulation& run, double seconds) {
    const long until = run.sample().step + std::lround(seconds / run.settings().dt.value());
    while (run.sample().step < until) run.advance();
}

// Edge of the cube that turns as easily as the body about its easiest axis [m].
double size_of(const Body& body) {
    return std::sqrt(6.0 * body.inverse_mass / body.inverse_inertia.maxCoeff());
}

// In sizes. What is round may turn in its place.
double drift_of(const Body& before, const Body& after) {
    const double moved = (after.position - before.position).norm() / size_of(before);
    const bool is_round = before.inverse_inertia.minCoeff() == before.inverse_inertia.maxCoeff();
    return is_round ? moved : std::max(moved, after.orientation.angularDistance(before.orientation));
}

JudgedSleepers run(const demos::families::Member& member) {
    JudgedSleepers judged{.member = member};
    demos::SceneDescription scene = member.prospect.scene;
    scene.options["preset"] = "default";
    scene.options["threads"] = "1";
    Random random(static_cast<std::uint64_t>(member.seed));
    Simulation first = start(scene);
    advance(first, member.prospect.rest_by + random.in(0.0, latest));
    demos::SceneDescription state = resumed(scene, first.scene(), first.checkpoint());
    state.options["rest"] = "off";
    Simulation awake = start(state);
    const std::vector<Body> before = first.scene().world.bodies;
    const engine::Rest& rest = *first.scene().world.rest;
    std::vector<char> asleep;
    for (int body = 0; body < static_cast<int>(before.size()); ++body) asleep.push_back(rest.is_at_rest(body));
    for (long step = std::lround(watched / first.settings().dt.value()); step > 0; --step) {
        first.advance();
        for (std::size_t i = 0; i < asleep.size(); ++i) {
            asleep[i] = asleep[i] && rest.is_at_rest(static_cast<int>(i));
        }
    }
    advance(awake, watched);
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i].is_static()) continue;
        ++judged.movable;
        if (!asleep[i]) continue;
        ++judged.asleep;
        judged.drift = std::max(judged.drift, drift_of(before[i], awake.scene().world.bodies[i]));
    }
    return judged;
}

}  // namespace

JudgedSleepers judge_sleepers(const demos::families::Member& member) {
    try {
        return run(member);
    } catch (const std::exception& error) {
        return {.member = member, .error = error.what()};
    }
}

std::vector<JudgedSleepers> judge_sleepers(const FamilyRequest& request, const GoOn& go_on) {
    return results_of<JudgedSleepers>(
        request.members, [&](long i) { return judge_sleepers(member_of(request, i)); }, go_on);
}

std::string sleepers_table(const std::vector<JudgedSleepers>& judged) {
    std::string text =
        fmt::format("{:<14}{:>8}{:>7}{:>8}{:>8}{:>11}\n", "family", "members", "fail", "bodies", "asleep", "drift");
    const auto add = [&](std::string_view name, const demos::families::Family* family) {
        int members = 0, fail = 0, movable = 0, asleep = 0;
        double drift = 0.0;
        for (const JudgedSleepers& one : judged) {
            if (family && one.member.family != family) continue;
            ++members;
            fail += !one.holds();
            movable += one.movable;
            asleep += one.asleep;
            drift = std::max(drift, one.drift);
        }
        if (members == 0) return;
        text += fmt::format("{:<14}{:>8}{:>7}{:>8}{:>8}{:>11.2g}\n", name, members, fail, movable, asleep, drift);
    };
    for (const demos::families::Family& family : demos::families::families()) add(family.name, &family);
    add("all", nullptr);
    return text;
}

}  // namespace pushfactor::tests
