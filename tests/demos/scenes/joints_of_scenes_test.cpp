// Joints in scenes and their files: what is built, saved, resumed, drawn, refused and left out.
#include "demos/base/text/errors.h"
#include "demos/base/text/json.h"
#include "demos/options/choices.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/overlays/overlay.h"
#include "demos/runs/checkpoint.h"
#include "demos/runs/simulation.h"
#include "demos/scenes/scene_file.h"
#include "engine/base/invalid_input.h"
#include "engine/bodies/diagnostics.h"
#include "tests/catch.h"
#include "tests/demos/program.h"
#include "tests/demos/scenes/said_of.h"
#include "tests/settings.h"

#include <cmath>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::RowKind;
using engine::Vector3;
using tests::Folder;
using tests::said_of;

namespace {

SceneDescription read(const std::string& text) {
    const Folder folder;
    folder.write("my.json", text);
    return read_scene_file(folder / "my.json");
}

// A cart on the ground: a box with two wheels that overlap it, on hinges with `hinge` as further keys.
std::string cart(const std::string& hinge, const std::string& rest = "") {
    const auto wheel = [](const std::string& name, const char* x) {
        return R"({"name": ")" + name + R"(", "shape": "sphere", "radius_m": 0.4, "mass_kg": 1, "position_m": [)" +
               x + R"(, 0.4, 0], "friction": 1})";
    };
    const auto joint = [&](const std::string& name, const char* x) {
        return R"({"type": "hinge", "a": {"body": "box", "point_m": [)" + std::string(x) +
               R"(, -0.1, 0]}, "b": {"body": ")" + name + R"("}, "axis": [0, 0, 2])" + hinge + "}";
    };
    return R"({"version": 1, "gravity_m_per_s2": [0, -10, 0], "contacts": true, "bodies": [
        {"name": "ground", "shape": "plane", "friction": 1},
        {"name": "box", "shape": "box", "size_m": [2, 0.2, 0.6], "mass_kg": 4, "position_m": [0, 0.5, 0]},)" +
           wheel("rear", "-0.8") + "," + wheel("front", "0.8") + R"(], "joints": [)" + joint("rear", "-0.8") + "," +
           joint("front", "0.8") + "]" + rest + "}";
}

constexpr const char* driven = R"(, "motor": {"speed_rad_per_s": -5, "max_torque_n_m": 3})";

Settings with_rest() {
    Settings settings = tests::awake_settings("default");
    settings.rest = true;
    return settings;
}

}  // namespace

TEST_CASE("a cart on driven wheels runs at speed x radius, and its motors' work is its energy") {
    const Settings settings = tests::awake_settings("default");
    Simulation run(build_scene(read(cart(driven)), settings), settings);
    for (int i = 0; i < 300; ++i) run.advance();
    const engine::Body& box = run.scene().world.bodies[1];
    CHECK(std::abs(velocity(box).x() - 2.0) < 1e-3);
    CHECK(std::abs(velocity(box).y()) < 1e-3);
    CHECK(std::abs(box.position.z()) < 1e-6);
    CHECK(run.sample().energy_gain < 0.01 * run.sample().kinetic_energy);
    CHECK(run.sample().max_length_error < 1e-3);
    const engine::StepCount& count = run.sample().count;
    CHECK(count.rows(RowKind::joint) == 10);
    CHECK(count.rows(RowKind::motor) == 2);
    CHECK(count.rows(RowKind::limit) == 0);
    CHECK(count.rows(RowKind::contact) == 2);  // the wheels on the ground; not on the box, which they overlap
}

TEST_CASE("the rover drives over planks on sprung arms without coming apart or gaining energy") {
    const Choices choices = understand(std::string(PUSHFACTOR_SOURCE_DIR) + "/assets/scenes/rover.json", {});
    Simulation run(choices);
    const double loaded = run.scene().world.bodies[1].position.y();
    for (int i = 0; i < 240; ++i) {
        const Sample& sample = run.advance();
        REQUIRE(sample.max_length_error < 1e-3);
        REQUIRE(sample.residual < 1e-3);
        REQUIRE(sample.energy_gain < 0.01);
    }
    const engine::Body& chassis = run.scene().world.bodies[1];
    CHECK(chassis.position.x() > 6.0);
    CHECK(std::abs(chassis.position.y() - loaded) < 0.3);
    CHECK((chassis.orientation * Vector3::UnitY()).y() > 0.95);
}

TEST_CASE("a motor that hangs on a moved body: its work and that of the motion are not taken for a gain") {
    SceneDescription scene;
    scene.name = "carousel";
    scene.bodies.push_back({.name = "table", .shape = BoxShape{{4, 0.2, 4}}});
    scene.bodies[0].motion =
        MotionDescription{.kind = SteadyMotion{.velocity = {0, 1, 0}, .angular_velocity = {0, 2, 0}}};
    scene.bodies.push_back({.name = "arm",
                            .shape = BoxShape{{1, 0.2, 0.2}},
                            .mass = 3.0,
                            .position = {2, 0.5, 0},
                            .velocity = {0, 1, -4},
                            .angular_velocity = {0, 2, 0}});
    JointDescription joint{.a = {.body = "table", .point = {1.5, 0.5, 0}},
                           .b = {.body = "arm", .point = {-0.5, 0, 0}}};
    joint.hinge = HingeDescription{.axis = Vector3::UnitY(), .motor = engine::Motor{.speed = 4, .max_torque = 20}};
    scene.joints.push_back(joint);
    for (const long division : {60, 240}) {
        Settings settings = tests::awake_settings("exact");
        settings.dt = {1, division};
        Simulation run(build_scene(scene, settings), settings);
        double most = 0.0;
        double gain = 0.0;
        for (long i = 0; i < 5 * division; ++i) {
            const Sample& sample = run.advance();
            gain = std::max(gain, std::abs(sample.energy_gain));
            most = std::max(most, sample.kinetic_energy);
        }
        CHECK(most > 60.0);  // J
        CHECK(gain < 0.01);  // J
        const Vector3 turning = angular_velocity(run.scene().world.bodies[1]);
        CHECK((turning - Vector3(0, 6, 0)).norm() < 1e-6);  // that of the table and of the motor
    }
}

TEST_CASE("joined bodies touch each other only where the joint says so") {
    const Settings settings = tests::awake_settings("default");
    Simulation apart(build_scene(read(cart("")), settings), settings);
    CHECK(apart.sample().penetration.max < 0.001);
    Simulation touching(build_scene(read(cart(R"(, "collide": true)")), settings), settings);
    CHECK(touching.sample().penetration.max > 0.1);
    CHECK(touching.advance().count.rows(RowKind::contact) > 2);
}

TEST_CASE("a braked cart comes to rest with its wheels, a driven one does not") {
    const std::string brake = R"(, "motor": {"speed_rad_per_s": 0, "max_torque_n_m": 3})";
    Simulation braked(build_scene(read(cart(brake)), with_rest()), with_rest());
    for (int i = 0; i < 180; ++i) braked.advance();
    CHECK(braked.sample().count.at_rest == 3);
    CHECK(braked.sample().count.rows() == 0);
    const std::string stalled = R"(, "motor": {"speed_rad_per_s": -1, "max_torque_n_m": 1e-9})";
    Simulation driving(build_scene(read(cart(stalled)), with_rest()), with_rest());
    for (int i = 0; i < 180; ++i) driving.advance();
    CHECK(driving.sample().count.at_rest == 0);
}

TEST_CASE("a saved run with hinges, motors and limits goes on to the same bits, awake or at rest") {
    for (const char* const hinge :
         {driven, R"(, "limits_rad": [-0.5, 1])", R"(, "motor": {"speed_rad_per_s": 0, "max_torque_n_m": 3})"}) {
        for (const char* const solver : {"auto", "pgs", "direct"}) {
            Settings settings = with_rest();
            settings.solver = solver;
            const SceneDescription scene = read(cart(hinge));
            Simulation whole(build_scene(scene, settings), settings);
            for (int i = 0; i < 100; ++i) whole.advance();
            const SceneDescription saved = resumed(scene, whole.scene(), whole.checkpoint());
            const std::string text = scene_file_text(saved);
            CHECK(scene_file_text(read(text)) == text);
            const Json json = parse_json(text);
            CHECK(json["state"]["joint_forces_n"].size() == 2);
            CHECK(json["joints"][1].contains("zero_wxyz"));
            Simulation again(build_scene(read(text), settings), settings);
            for (int i = 0; i < 60; ++i) {
                whole.advance();
                again.advance();
                REQUIRE(engine::state_hash(again.scene().world.bodies) ==
                        engine::state_hash(whole.scene().world.bodies));
            }
        }
    }
}

TEST_CASE("joints are drawn, a hinge as a pin along its axis, and their forces are arrows") {
    const Settings settings = tests::awake_settings("default");
    Simulation run(build_scene(read(cart("")), settings), settings);
    for (int i = 0; i < 60; ++i) run.advance();
    const renderer::Picture picture = pictures::draw_list(run.scene(), run.scene().view);
    REQUIRE(picture.bars.size() == 2);
    CHECK(std::abs(picture.bars[0].to.z - picture.bars[0].from.z) > 0.3f);
    CHECK(std::abs(picture.bars[0].to.x - picture.bars[0].from.x) < 0.01f);
    const auto forces = pictures::quantities(run.scene(), OverlayKind::forces);
    // Two contacts, and two joints with two movable ends each; each wheel carries half of the box.
    REQUIRE(forces.size() == 6);
    CHECK(std::abs(forces[2].value.y() - 20.0) < 0.5);
    CHECK((forces[2].value + forces[3].value).norm() < 1e-12);
}

TEST_CASE("a scene without joints has none, and RATTLE is for bars") {
    const BuiltScene none = build_scene(read(R"({"version": 1, "bodies": []})"), tests::awake_settings("default"));
    CHECK(none.joints == nullptr);
    const std::string arm = R"({"version": 1, "gravity_m_per_s2": [0, -10, 0],
        "bodies": [{"name": "arm", "shape": "box", "size_m": [0.1, 1, 0.1], "mass_kg": 1}],
        "joints": [{"type": "ball", "a": {"body": "world", "point_m": [0, 0.5, 0]},
                    "b": {"body": "arm", "point_m": [0, 0.5, 0]}}], "options": {"scheme": "rattle"}})";
    CHECK_THAT(said_of(arm), Catch::Contains("--scheme rattle: must be auto or whole for a scene with joints"));
}

TEST_CASE("wrong joints are refused with the path, the value and what is allowed") {
    const auto scene = [](const std::string& joint) {
        return R"({"version": 1, "bodies": [{"name": "a", "shape": "sphere", "radius_m": 1, "mass_kg": 1},
            {"name": "s", "shape": "sphere", "radius_m": 1, "static": true}], "joints": [)" +
               joint + "]}";
    };
    const std::string ends = R"("a": {"body": "world"}, "b": {"body": "a"})";
    const auto hinge = [&](const std::string& rest) {
        return scene(R"({"type": "hinge", )" + ends + R"(, "axis": [0, 0, 1])" + rest + "}");
    };
    const std::vector<std::pair<std::string, std::string>> wrong{
        {scene(R"({"type": "slider", )" + ends + "}"), "joints[0].type \"slider\": must be one of hinge, ball"},
        {scene(R"({"type": "hinge", )" + ends + "}"), "joints[0].axis: is missing"},
        {scene(R"({"type": "hinge", )" + ends + R"(, "axis": [0, 0, 0]})"),
         "joints[0].axis [0,0,0]: must be a vector from 1e-100 to 1e+100 long"},
        {scene(R"({"type": "ball", )" + ends + R"(, "axis": [0, 0, 1]})"),
         "joints[0].axis [0,0,1]: must be left out: a ball joint has no axis"},
        {scene(R"({"type": "ball", "a": {"body": "world"}, "b": {"body": "s"}})"),
         "joints[0].b.body \"s\": must be a movable body, as a is static"},
        {scene(R"({"type": "ball", "a": {"body": "a"}, "b": {"body": "a"}})"), "must be another body than a"},
        {hinge(R"(, "motor": {})"), "joints[0].motor.speed_rad_per_s: is missing"},
        {hinge(R"(, "motor": {"speed_rad_per_s": NaN})"),
         "joints[0].motor.speed_rad_per_s NaN: must be a finite number"},
        {hinge(R"(, "motor": {"speed_rad_per_s": 1, "max_torque_n_m": 0})"),
         "joints[0].motor.max_torque_n_m 0: must be"},
        {hinge(R"(, "motor": {"speed_rad_per_s": 1, "torque": 0})"), "joints[0].motor.torque: unknown key"},
        {hinge(R"(, "limits_rad": [1, -1])"), "joints[0].limits_rad [1,-1]: must be two angles"},
        {hinge(R"(, "limits_rad": [-4, 4])"), "joints[0].limits_rad [-4,4]: must be two angles"},
        {hinge(R"(, "limits_rad": [1])"), "joints[0].limits_rad [1]: must be two angles"},
        {hinge(R"(, "zero_wxyz": [1, 1, 0, 0])"), "of length 1"},
        {hinge(R"(, "limits": [0, 1])"), "joints[0].limits: unknown key"},
    };
    for (const auto& [text, message] : wrong) {
        INFO(text);
        CHECK_THAT(said_of(text), Catch::Contains(message));
    }
    CHECK(said_of(hinge(R"(, "limits_rad": [-3, 3], "motor": {"speed_rad_per_s": 1})")) == "accepted");
    const std::string state = cart("", R"(, "state": {"joint_forces_n": [[[0, 0]], [[0, 0]]]})");
    CHECK_THAT(said_of(state), Catch::Contains("must be 5 times two numbers, one per row"));
    // A motor without a largest torque has had rows of its limits beside it; files with their forces go on loading.
    const auto motor_at_limits = [&](const std::string& forces) {
        std::string text = hinge(R"(, "limits_rad": [-3, 3], "motor": {"speed_rad_per_s": 1})");
        text.insert(text.size() - 1, R"(, "state": {"joint_forces_n": [[)" + forces + "]]}");
        return said_of(text);
    };
    const std::string six = "[0, 0], [0, 0], [0, 0], [0, 0], [0, 0], [1, 1]";
    CHECK(motor_at_limits(six) == "accepted");
    CHECK(motor_at_limits(six + ", [0, 0], [2, 2]") == "accepted");
    CHECK_THAT(motor_at_limits(six + ", [0, 0]"), Catch::Contains("must be 6 times two numbers, one per row"));
}
