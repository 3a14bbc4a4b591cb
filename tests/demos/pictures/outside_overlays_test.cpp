// Overlays of what acts from outside, against closed forms: forces and torques, motors, moved bodies, pairs that do
// not touch.
#include "demos/base/text/errors.h"
#include "demos/pictures/overlays/overlay.h"
#include "demos/runs/simulation.h"
#include "tests/catch.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <numbers>

using namespace pushfactor::demos;
using namespace pushfactor::demos::pictures;
using pushfactor::engine::Vector3;

namespace {

BodyDescription ball(const char* name, const Vector3& position) {
    return {.name = name, .shape = SphereShape{0.5}, .mass = 2.0, .position = position};
}

Simulation after(const SceneDescription& scene, long steps) {
    const Settings settings = pushfactor::tests::awake_settings("default");
    Simulation run(build_scene(scene, settings), settings);
    while (run.sample().step < steps) run.advance();
    return run;
}

std::vector<Quantity> of_kind(const Simulation& run, OverlayKind overlay, std::size_t kind) {
    std::vector<Quantity> found = quantities(run.scene(), overlay);
    std::erase_if(found, [kind](const Quantity& quantity) { return quantity.kind != kind; });
    return found;
}

}  // namespace

TEST_CASE("forces and torques from outside are shown while they act, where they act, turned with their body") {
    SceneDescription scene;
    scene.name = "pushed";
    scene.gravity.setZero();
    scene.bodies.push_back(ball("ball", {1, 2, 3}));
    scene.bodies.back().orientation = pushfactor::engine::Quaternion(
        Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3::UnitZ()));  // x of the body is y of the world
    scene.forces.push_back({.body = "ball",
                            .force = {5, 0, 0},
                            .point = {0.5, 0, 0},
                            .frame = pushfactor::engine::Poke::Frame::body,
                            .until = 0.1});
    scene.forces.push_back({.body = "ball", .torque = {0, 0, 7}, .from = 0.1});

    const Simulation start = after(scene, 0);
    const auto forces = of_kind(start, OverlayKind::forces, 3);
    REQUIRE(forces.size() == 1);
    CHECK((forces[0].place - Vector3(1, 2.5, 3)).norm() < 1e-12);
    CHECK((forces[0].value - Vector3(0, 5, 0)).norm() < 1e-12);
    CHECK(of_kind(start, OverlayKind::torques, 0).empty());

    const Simulation later = after(scene, 6);
    CHECK(of_kind(later, OverlayKind::forces, 3).empty());
    const auto torques = of_kind(later, OverlayKind::torques, 0);
    REQUIRE(torques.size() == 1);
    CHECK((torques[0].place - later.scene().world.bodies[0].position).norm() == 0.0);
    CHECK((torques[0].value - Vector3(0, 0, 7)).norm() == 0.0);
}

TEST_CASE("the torque of a brake that holds an arm up is the moment of its weight, on whichever body is b") {
    for (const bool arm_is_b : {true, false}) {
        SceneDescription scene;
        scene.name = "arm";
        scene.bodies.push_back(ball("arm", {1.5, 0, 0}));
        JointDescription joint;
        (arm_is_b ? joint.b : joint.a) = {.body = "arm", .point = {-1.5, 0, 0}};
        joint.hinge = HingeDescription{.motor = pushfactor::engine::Motor{.speed = 0.0}};
        scene.joints.push_back(joint);
        const auto torques = of_kind(after(scene, 60), OverlayKind::torques, 1);
        REQUIRE(torques.size() == 1);
        CHECK((torques[0].value - Vector3(0, 0, 2.0 * 10.0 * 1.5)).norm() < 1e-6);  // m g l
        CHECK(torques[0].place.norm() < 1e-9);
    }
}

TEST_CASE("a moved body shows the velocity of its centre and, if it turns, omega r around its axis") {
    SceneDescription scene;
    scene.name = "table";
    scene.contacts = true;
    scene.bodies.push_back({.name = "table", .shape = BoxShape{{2, 1, 2}}});
    scene.bodies.back().motion =
        MotionDescription{.kind = SteadyMotion{.velocity = {3, 0, 0}, .angular_velocity = {0, 2, 0}}};
    scene.bodies.push_back(ball("ball", {0, 5, 0}));
    const auto shown = of_kind(after(scene, 1), OverlayKind::velocities, 1);
    REQUIRE(shown.size() == 5);
    CHECK((shown[0].value - Vector3(3, 0, 0)).norm() < 1e-9);
    for (std::size_t i = 1; i < 5; ++i) {
        const Vector3 arm = shown[i].place - shown[0].place;
        CHECK(arm.norm() == Approx(1.5));  // half of the box's diagonal
        CHECK(arm.y() == Approx(0.0).margin(1e-12));
        CHECK((shown[i].value - (Vector3(3, 0, 0) + Vector3(0, 2, 0).cross(arm))).norm() < 1e-9);
    }
}

TEST_CASE("lines join the pairs that do not touch, joined bodies among them, and groups with their middle") {
    SceneDescription scene;
    scene.name = "apart";
    scene.contacts = true;
    for (const char* name : {"one", "two", "three", "four"}) {
        scene.bodies.push_back(ball(name, {2.0 * static_cast<double>(scene.bodies.size()), 0, 0}));
    }
    scene.no_contacts.emplace_back("three", "one");
    scene.joints.push_back({.a = {.body = "one", .point = {1, 0, 0}}, .b = {.body = "two", .point = {-1, 0, 0}}});
    scene.bodies[1].group = scene.bodies[3].group = "pair";
    const Simulation run = after(scene, 0);

    const auto pairs = of_kind(run, OverlayKind::no_contacts, 0);
    REQUIRE(pairs.size() == 2);
    CHECK(std::abs(pairs[0].value.x()) == Approx(4.0));  // one and three
    CHECK(std::abs(pairs[1].value.x()) == Approx(2.0));  // one and two
    const auto groups = of_kind(run, OverlayKind::no_contacts, 1);
    REQUIRE(groups.size() == 2);
    for (const Quantity& line : groups) CHECK((line.place + line.value - Vector3(4, 0, 0)).norm() < 1e-12);

    SceneDescription plain = scene;
    plain.no_contacts.clear();
    plain.joints.clear();
    for (BodyDescription& body : plain.bodies) body.group.clear();
    CHECK_THROWS_WITH(
        require_shown(after(plain, 0).scene(), {{.kind = OverlayKind::no_contacts}}),
        "--overlay no-contacts: scene apart has no pairs that do not touch, so there is nothing to show");
    CHECK_THROWS_WITH(require_shown(after(plain, 0).scene(), {{.kind = OverlayKind::torques}}),
                      "--overlay torques: scene apart has neither motors nor torques, so there is nothing to show");
}
