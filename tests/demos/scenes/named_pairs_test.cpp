// What a scene says about pairs: bodies that do not touch, and friction and restitution of pairs of materials.
#include "demos/base/text/errors.h"
#include "demos/options/choices.h"
#include "demos/runs/scene.h"
#include "demos/runs/simulation.h"
#include "demos/scenes/scene_file.h"
#include "tests/catch.h"
#include "tests/demos/program.h"
#include "tests/demos/scenes/said_of.h"
#include "tests/settings.h"

#include <cmath>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Quaternion;
using engine::Vector3;
using tests::Folder;
using tests::said_of;

namespace {

BodyDescription ball(const std::string& name, double x, double speed) {
    return {.name = name,
            .shape = SphereShape{0.5},
            .mass = 1.0,
            .position = {x, 0, 0},
            .velocity = {speed, 0, 0},
            .restitution = 1.0};
}

// Two balls that fly at each other, and one that waits behind the second.
SceneDescription balls() {
    SceneDescription scene;
    scene.name = "balls";
    scene.gravity.setZero();
    scene.contacts = true;
    scene.bodies = {ball("a", -1, 4), ball("b", 1, -4), ball("c", 2.5, 0)};
    return scene;
}

// m/s along x of each body after a second.
std::vector<double> speeds_of(const SceneDescription& scene) {
    const Settings settings = tests::awake_settings("default");
    Simulation simulation(build_scene(scene, settings), settings);
    for (int i = 0; i < 60; ++i) simulation.advance();
    std::vector<double> speeds;
    for (const auto& body : simulation.scene().world.bodies) speeds.push_back(velocity(body).x());
    return speeds;
}

// A plate at `slope`, and cubes of these materials that stand on it 2 m apart; all have friction 0.5.
SceneDescription slope_of(double slope, const std::vector<std::string>& materials) {
    SceneDescription scene;
    scene.name = "slope";
    scene.contacts = true;
    const Quaternion turn(Eigen::AngleAxisd(slope, Vector3::UnitZ()));
    scene.bodies.push_back({.name = "plate", .shape = PlaneShape{}, .orientation = turn, .material = "plate"});
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const Vector3 place(0, 0.5, 2.0 * static_cast<double>(i));
        scene.bodies.push_back({.name = "cube " + std::to_string(i),
                                .shape = BoxShape{},
                                .mass = 1.0,
                                .position = turn * place,
                                .orientation = turn,
                                .material = materials[i]});
    }
    return scene;
}

// m along the slope of each cube after a second.
std::vector<double> slid(const SceneDescription& scene) {
    const Settings settings = tests::awake_settings("default");
    Simulation simulation(build_scene(scene, settings), settings);
    std::vector<double> distances;
    for (int i = 0; i < 60; ++i) simulation.advance();
    for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
        distances.push_back((simulation.scene().world.bodies[i].position - scene.bodies[i].position).norm());
    }
    return distances;
}

std::string scene_with(const std::string& rest) {
    return R"({"version": 1, "bodies": [
        {"name": "a", "shape": "sphere", "radius_m": 0.5, "mass_kg": 1, "material": "ice"},
        {"name": "b", "shape": "sphere", "radius_m": 0.5, "mass_kg": 1, "position_m": [2, 0, 0]}])" +
           rest + "}";
}

}  // namespace

TEST_CASE("bodies of a group, and pairs that are named, pass through each other and touch all others") {
    const std::vector<double> all = speeds_of(balls());
    CHECK(std::abs(all[0] + 4.0) < 1e-6);  // a and b bounce off each other, and b gives its speed to c
    CHECK(std::abs(all[1]) < 1e-6);
    CHECK(std::abs(all[2] - 4.0) < 1e-6);

    SceneDescription grouped = balls(), named = balls();
    grouped.bodies[0].group = grouped.bodies[1].group = "air";
    named.no_contacts = {{"b", "a"}};
    for (const SceneDescription& scene : {grouped, named}) {
        const std::vector<double> some = speeds_of(scene);
        CHECK(std::abs(some[0]) < 1e-6);  // through b, and stopped by c, which it pushes on
        CHECK(std::abs(some[1] + 4.0) < 1e-6);
        CHECK(std::abs(some[2] - 4.0) < 1e-6);
    }
    SceneDescription apart = balls();
    apart.bodies[0].group = "air";
    apart.bodies[1].group = "water";
    CHECK(speeds_of(apart) == all);
}

TEST_CASE("a pair that does not touch has no rows, no pairs and no penetration, also with a plane") {
    SceneDescription scene = slope_of(0.0, {"", ""});
    scene.bodies[1].position = scene.bodies[2].position;
    const Settings settings = tests::awake_settings("default");
    Simulation with(build_scene(scene, settings), settings);
    CHECK(with.sample().penetration.max > 0.5);
    scene.no_contacts = {{"cube 0", "cube 1"}, {"plate", "cube 1"}};
    Simulation without(build_scene(scene, settings), settings);
    CHECK(without.sample().penetration.max < 0.01);
    CHECK(without.advance().count.rows(engine::RowKind::contact) == 4);  // cube 0 on the plate
}

TEST_CASE("the friction of a pair decides from which slope a cube slides, and how fast") {
    const double mu = 0.2;
    const auto with = [&](double slope) {
        SceneDescription scene = slope_of(slope, {"ice", "wood", ""});
        scene.materials = {{.a = "ice", .b = "plate", .friction = mu}, {.a = "ice", .b = "wood", .friction = 7.0}};
        return slid(scene);
    };
    const std::vector<double> below = with(std::atan(mu) - 0.01);
    CHECK(below[0] < 1e-3);
    const double slope = std::atan(mu) + 0.05;
    const std::vector<double> above = with(slope);
    const double acceleration = 10.0 * (std::sin(slope) - mu * std::cos(slope));
    CHECK(std::abs(above[0] / (0.5 * acceleration) - 1.0) < 0.03);
    // The others keep 0.5, the root of the product.
    for (const std::size_t other : {1u, 2u}) CHECK(above[other] < 1e-3);
    SceneDescription plain = slope_of(slope, {"", "", ""});
    const std::vector<double> unnamed = slid(plain);
    CHECK(above[2] == unnamed[2]);
}

TEST_CASE("the option --friction is the friction of all pairs, those of materials too") {
    SceneDescription scene = slope_of(std::atan(0.2) + 0.05, {"ice"});
    scene.materials = {{.a = "ice", .b = "plate", .friction = 0.2}};
    Settings settings = tests::awake_settings("default");
    settings.friction = 0.5;
    Simulation simulation(build_scene(scene, settings), settings);
    for (int i = 0; i < 60; ++i) simulation.advance();
    CHECK((simulation.scene().world.bodies[1].position - scene.bodies[1].position).norm() < 1e-3);
}

TEST_CASE("the restitution of a pair lets bodies bounce that otherwise do not, and holds bodies that do") {
    SceneDescription scene = balls();
    for (BodyDescription& body : scene.bodies) body.restitution = 0.0, body.material = body.name;
    scene.bodies[0].friction = scene.bodies[1].friction = 0.0;
    scene.materials = {{.a = "b", .b = "a", .restitution = 0.5}};
    const std::vector<double> bounced = speeds_of(scene);
    CHECK(std::abs(bounced[0] + 2.0) < 1e-6);
    scene = balls();
    for (BodyDescription& body : scene.bodies) body.material = "clay";
    scene.materials = {{.a = "clay", .b = "clay", .restitution = 0.0}};
    CHECK(std::abs(speeds_of(scene)[0]) < 1e-6);
}

TEST_CASE("groups, pairs, materials and forces in a body's frame are the same after writing and reading") {
    SceneDescription scene = balls();
    scene.bodies[0].group = "air";
    scene.bodies[1].material = "ice";
    scene.no_contacts = {{"a", "c"}};
    scene.materials = {{.a = "ice", .b = "ice", .friction = 0.1}};
    scene.forces = {{.body = "a",
                     .force = {1, 2, 3},
                     .torque = {4, 5, 6},
                     .point = {0.1, 0.2, 0.3},
                     .frame = engine::Poke::Frame::body,
                     .from = 0.5}};
    const Folder folder;
    folder.write("my.json", scene_file_text(scene));
    const SceneDescription again = read_scene_file(folder / "my.json");
    CHECK(scene_file_text(again) == scene_file_text(scene));
    CHECK(again.bodies[0].group == "air");
    CHECK(again.bodies[1].material == "ice");
    CHECK(again.no_contacts == scene.no_contacts);
    REQUIRE(again.materials.size() == 1);
    CHECK(again.materials[0].friction == 0.1);
    CHECK(!again.materials[0].restitution);
    REQUIRE(again.forces.size() == 1);
    CHECK(again.forces[0].torque == scene.forces[0].torque);
    CHECK(again.forces[0].point == scene.forces[0].point);
    CHECK(again.forces[0].frame == engine::Poke::Frame::body);
}

TEST_CASE("what a file says wrongly about pairs and forces is refused by its name") {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {R"(, "no_contacts": [["a"]])", "no_contacts[0] [\"a\"]: must be two names of bodies"},
        {R"(, "no_contacts": [["a", "x"]])", "no_contacts[0][1] \"x\": must be the name of a body"},
        {R"(, "no_contacts": [["a", "a"]])", "no_contacts[0][1] \"a\": must be another body than the first"},
        {R"(, "material_pairs": [{"a": "ice", "b": "snow", "friction": 1}])",
         "material_pairs[0].b \"snow\": must be the material of a body"},
        {R"(, "material_pairs": [{"a": "ice", "b": "ice"}])", "must be given friction or restitution, or both"},
        {R"(, "material_pairs": [{"a": "ice", "b": "ice", "friction": -1}])",
         "material_pairs[0].friction -1: must be a number from 0 to 100"},
        {R"(, "material_pairs": [{"a": "ice", "b": "ice", "friction": 1}, {"a": "ice", "b": "ice", "friction": 2}])",
         "must be a pair that is listed once"},
        {R"(, "forces": [{"body": "a"}])", "forces[0].force_n: is missing"},
        {R"(, "forces": [{"body": "a", "torque_n_m": 1}])", "forces[0].torque_n_m 1: must be"},
        {R"(, "forces": [{"body": "a", "torque_n_m": [0, 0, 1], "point_m": [1, 0, 0]}])",
         "forces[0].point_m [1,0,0]: must be left out without force_n"},
        {R"(, "forces": [{"body": "a", "force_n": [0, 0, 1], "frame": "b"}])",
         "forces[0].frame \"b\": must be one of world, body"},
    };
    for (const auto& [rest, message] : wrong) {
        INFO(rest);
        CHECK_THAT(said_of(scene_with(rest)), Catch::Contains(message));
    }
    CHECK(said_of(scene_with(R"(, "forces": [{"body": "a", "torque_n_m": [0, 0, 1]}], "no_contacts": [["b", "a"]],
        "material_pairs": [{"a": "ice", "b": "ice", "restitution": 0.5}])")) == "accepted");
}
