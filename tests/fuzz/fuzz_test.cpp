// Random scenes fulfil the claims, and the judge detects violations.
#include "demos/runs/simulation.h"
#include "demos/scenes/scene_file.h"
#include "tests/catch.h"
#include "tests/demos/program.h"
#include "tests/fuzz/campaign.h"
#include "tests/fuzz/random_scene.h"
#include "tests/fuzz/shrink.h"
#include "tests/fuzz/step_claims.h"

using namespace pushfactor;
using namespace pushfactor::tests;
using engine::Vector3;

namespace {

// Two balls and a box that fly into each other, nothing else.
demos::SceneDescription collision(const std::string& push) {
    demos::SceneDescription scene;
    scene.contacts = true;
    scene.gravity = Vector3::Zero();
    scene.bodies = {{.name = "left", .shape = demos::SphereShape{0.5}, .mass = 1.0, .position = {-0.9, 0.1, 0}},
                    {.name = "box", .shape = demos::BoxShape{{1, 1, 1}}, .mass = 2.0},
                    {.name = "right", .shape = demos::SphereShape{0.5}, .mass = 3.0, .position = {0.9, 0.2, 0.1}}};
    scene.bodies[0].velocity = {2, 0, 0};
    scene.bodies[2].velocity = {-1, 0.5, 0};
    scene.options = {{"push", push}, {"solver", "direct"}};  // of whole steps
    return scene;
}

// One step of `scene`, which may be tampered with before it is judged.
struct JudgedStep {
    explicit JudgedStep(const demos::SceneDescription& scene)
        : settings(settings_of(scene)), built(build_scene(scene, settings)), before(built.world.bodies) {
        built.world.step(settings.dt.value());
    }
    std::string broken() const {
        const auto found = broken_claim({.before = before,
                                         .world = built.world,
                                         .isolated = true,
                                         .shifts = settings.contacts.kind == engine::PushKind::single_frame,
                                         .monotone = true});
        return found ? found->claim : "";
    }
    engine::Body& body(std::size_t i) { return built.world.bodies[i]; }

    demos::Settings settings;
    demos::BuiltScene built;
    std::vector<engine::Body> before;
};

}  // namespace

TEST_CASE("in 200 random scenes forces stay within bounds, momentum is kept and energy comes from the push alone") {
    const Campaign campaign = judge_scenes(1, 200, [](long) { return true; });
    CHECK(campaign.judged == 200);
    CHECK(campaign.non_finite == 0);
    for (const Failure& failure : campaign.failures) {
        INFO("seed " << failure.seed << ", step " << failure.verdict.step << ": " << failure.verdict.what);
        INFO(demos::scene_file_text(failure.scene));
        CHECK(failure.verdict.claim == "");
    }
}

// With friction between bodies that are held there may be no impulses; what wrong ones leave meets again at once.
// Its hinges contradict each other, so that the last bits decide what it does.
TEST_CASE("impacts that have no answer make no energy out of nothing") {
    const demos::SceneDescription scene = random_scene(127);
    const demos::Settings settings = settings_of(scene);
    demos::Simulation run(build_scene(scene, settings), settings);
    double fastest = 0.0;  // J
    while (run.sample().step < whole_steps(settings)) {
        run.advance();
        fastest = std::max(fastest, run.sample().kinetic_energy);
    }
    CHECK(fastest < 1e4);  // 3470; 7.9e7 where they are repeated
}

TEST_CASE("a random scene is an ordinary scene file") {
    const Folder folder;
    for (const std::uint64_t seed : {3u, 14u, 15u, 92u}) {
        const demos::SceneDescription scene = random_scene(seed);
        folder.write("scene.json", demos::scene_file_text(scene));
        CHECK(demos::scene_file_text(demos::read_scene_file(folder / "scene.json")) == scene_file_text(scene));
        const Ended ended = shell(folder, "pushfactor run scene.json");
        INFO(ended.err);
        CHECK(ended.status == 0);
    }
}

TEST_CASE("a collision holds all claims, and a change of a billionth breaks the one that it belongs to") {
    for (const std::string push : {"none", "persistent", "single-frame"}) {
        INFO(push);
        CHECK(JudgedStep(collision(push)).broken() == "");

        JudgedStep pushed(collision(push));
        pushed.body(1).linear_momentum.x() += 1e-9;
        CHECK(pushed.broken() == "linear momentum");

        JudgedStep turned(collision(push));
        turned.body(2).angular_momentum.z() += 1e-9;
        CHECK(turned.broken() == "angular momentum");

        JudgedStep moved(collision(push));
        moved.body(0).position.y() += 1e-9;
        CHECK(moved.broken() == (push == "single-frame" ? "" : "angular momentum"));
    }
}

TEST_CASE("bodies may lose energy in a step, and gain none") {
    // Equal and opposite along the line between the centres, so that both momenta are kept.
    JudgedStep step(collision("persistent"));
    const Vector3 apart = 1e-3 * (step.body(2).position - step.body(0).position);
    step.body(0).linear_momentum -= apart;
    step.body(2).linear_momentum += apart;
    CHECK(step.broken() == "");  // they still approach each other, and slower
    step.body(0).linear_momentum -= 1e4 * apart;
    step.body(2).linear_momentum += 1e4 * apart;
    CHECK(step.broken() == "energy");
}

TEST_CASE("a correction for a single frame turns an isolated system by sum dx_corr x p and by nothing else") {
    // Judged as if nothing were corrected, the same step breaks the claim: the sum is not zero here.
    JudgedStep step(collision("single-frame"));
    CHECK(step.broken() == "");
    step.settings.contacts.kind = engine::PushKind::persistent;
    CHECK(step.broken() == "angular momentum");
}

TEST_CASE("an exact solve that is cut short gives no energy away") {
    // A shrunk random scene: after four factorisations the best residual belonged to forces that gave 1.9e4 J more
    // than the push.
    demos::SceneDescription scene;
    scene.contacts = true;
    scene.bodies = {
        {.name = "ground", .shape = demos::PlaneShape{}, .friction = 0.0},
        {.name = "ball", .shape = demos::SphereShape{0.02}, .mass = 1000.0, .position = {0.1, 0.3, 0.2}},
        {.name = "box", .shape = demos::BoxShape{{10, 7, 9}}, .mass = 0.4, .position = {-0.06, 0.7, 1}},
        {.name = "tower",
         .shape = demos::BoxShape{{60, 300, 80}},
         .mass = 0.004,
         .position = {-0.7, -0.01, -0.7},
         .friction = 0.0}};
    scene.bodies[1].friction = scene.bodies[2].friction = 1.0;
    scene.bodies[2].orientation = {-0.2340050627078756, 0.45382239704343613, 0.701751415433243,
                                   0.49682171199160874};
    scene.distances = {{.a = {"world", {3, 3, 2}}, .b = {"tower", {2, 1, -0.9}}}};
    scene.options = {
        {"preset", "paper"}, {"solver", "direct"}, {"iterations", "4"}, {"dt", "1/30"}, {"seconds", "0.1"}};
    const Verdict verdict = judge(scene);
    INFO(verdict.what);
    CHECK(verdict.claim == "");
}

TEST_CASE("shrinking keeps what makes a scene fail and drops the rest") {
    const demos::SceneDescription scene = random_scene(7);
    REQUIRE(scene.bodies.size() > 3);
    const std::string culprit = scene.bodies[2].name;
    const demos::SceneDescription smallest = shrink(scene, [&](const demos::SceneDescription& candidate) {
        return std::any_of(candidate.bodies.begin(), candidate.bodies.end(),
                           [&](const auto& body) { return body.name == culprit && body.position.norm() > 1e-4; });
    });
    REQUIRE(smallest.bodies.size() == 1);
    CHECK(smallest.bodies[0].name == culprit);
    CHECK(smallest.bodies[0].velocity == Vector3::Zero());
    CHECK(smallest.distances.empty());
    CHECK(smallest.forces.empty());
    CHECK(!smallest.contacts);
}
