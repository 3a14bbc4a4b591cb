// Polyhedra in scene files: points, OBJ files, densities, what is refused, and what is written.
#include "demos/options/choices.h"
#include "demos/runs/obstacles.h"
#include "demos/runs/simulation.h"
#include "demos/scenes/scene_file.h"
#include "demos/text/errors.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Vector3;
using tests::Folder;

namespace {

// A wedge, not about its centre of mass and not along its principal axes.
const std::string wedge =
    R"("shape": "polyhedron", "points_m": [[0, 0, 0], [2, 0.1, 0], [0.3, 1, 0.2], [0.1, 0.2, 1.5],
                            [2.1, 0.3, 1.4]])";

std::string scene_of(const std::string& bodies, const std::string& rest = "") {
    return R"({"version": 1, "gravity_m_per_s2": [0, -10, 0], "bodies": [)" + bodies + "]" + rest + "}";
}

SceneDescription read(const std::string& text) {
    const Folder folder;
    folder.write("my.json", text);
    return read_scene_file(folder / "my.json");
}

std::string refusal(const std::string& body) {
    try {
        read(scene_of(body));
    } catch (const UsageError& error) {
        const std::string message = error.what();
        return message.substr(message.find("bodies[0]"));
    }
    return "accepted";
}

const PolyhedronShape& polyhedron_of(const SceneDescription& scene, std::size_t body) {
    return std::get<PolyhedronShape>(scene.bodies[body].shape);
}

}  // namespace

TEST_CASE(
    "a polyhedron's points are where the file puts them, whatever its centre of mass and principal axes are") {
    const SceneDescription scene = read(scene_of(R"({"name": "a", "mass_kg": 3, "position_m": [5, 6, 7],
        "orientation_wxyz": [0.5, 0.5, -0.5, 0.5], )" +
                                                 wedge + "}"));
    const engine::Quaternion turn(0.5, 0.5, -0.5, 0.5);
    const BodyDescription& body = scene.bodies[0];
    const std::vector<Vector3> given{{0, 0, 0}, {2, 0.1, 0}, {0.3, 1, 0.2}, {0.1, 0.2, 1.5}, {2.1, 0.3, 1.4}};
    REQUIRE(polyhedron_of(scene, 0).points().size() == given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
        const Vector3 here = body.position + body.orientation * polyhedron_of(scene, 0).points()[i];
        CHECK((here - (Vector3(5, 6, 7) + turn * given[i])).norm() < 1e-12);
    }
}

TEST_CASE("a constraint's point on a polyhedron is given in the frame of its points") {
    const SceneDescription scene =
        read(scene_of(R"({"name": "a", "mass_kg": 3, "position_m": [5, 6, 7], )" + wedge + "}",
                      R"(, "distance_constraints": [{"a": {"body": "world", "point_m": [9, 9, 9]},
                                       "b": {"body": "a", "point_m": [2, 0.1, 0]}}])"));
    const BodyDescription& body = scene.bodies[0];
    const Vector3 held = body.position + body.orientation * scene.distances[0].b.point;
    CHECK((held - Vector3(7, 6.1, 7)).norm() < 1e-12);
}

TEST_CASE("a scene with polyhedra is written and read to the same bits, and runs to the same state") {
    const std::string text = scene_of(R"({"name": "ground", "shape": "plane"},
        {"name": "a", "mass_kg": 3, "position_m": [0, 2, 0], "angular_velocity_rad_per_s": [1, 2, 3], )" +
                                          wedge + R"(},
        {"name": "b", "static": true, "position_m": [4, 0, 0], )" +
                                          wedge + "}",
                                      R"(, "contacts": true)");
    const Folder folder;
    folder.write("my.json", text);
    const SceneDescription once = read_scene_file(folder / "my.json");
    folder.write("again.json", scene_file_text(once));
    const SceneDescription again = read_scene_file(folder / "again.json");
    CHECK(scene_file_text(again) == scene_file_text(once));
    const auto hash = [&](const std::string& command) {
        const std::string out = tests::shell(folder, "pushfactor run " + command).out;
        return out.substr(out.find("state_hash"), 32);
    };
    CHECK(hash("my.json --seconds 2") == hash("again.json --seconds 2"));
    // And a run that goes on is the run that was not interrupted.
    REQUIRE(tests::shell(folder, "pushfactor run my.json --seconds 1 --save-state half.json").status == 0);
    CHECK(hash("half.json --seconds 1") == hash("my.json --seconds 2"));
}

TEST_CASE("bodies with equal points share their mesh") {
    const SceneDescription scene = read(scene_of(R"({"name": "a", "mass_kg": 3, )" + wedge + R"(},
        {"name": "b", "mass_kg": 1, "position_m": [5, 0, 0], )" +
                                                 wedge + "}"));
    CHECK(polyhedron_of(scene, 0).mesh == polyhedron_of(scene, 1).mesh);
}

TEST_CASE("the hull of an OBJ file is taken, whose path begins at the scene file") {
    const Folder folder;
    std::filesystem::create_directories(folder / "shapes");
    folder.write("shapes/cube.obj",
                 "# a cube\no cube\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\n"
                 "v 1 1 1\nv -1 1 1\nv 0 0 0\nf 1 2 3 4\nf 5 6 7 8\n");
    folder.write("my.json", scene_of(R"({"name": "a", "shape": "polyhedron", "obj_file": "shapes/cube.obj",
                                         "density_kg_per_m3": 500})"));
    const SceneDescription scene = read_scene_file(folder / "my.json");
    CHECK(polyhedron_of(scene, 0).points().size() == 8);
    CHECK(polyhedron_of(scene, 0).mesh->hull().faces.size() == 6);
    CHECK(*scene.bodies[0].mass == Approx(4000));
    CHECK_THAT(scene_file_text(scene), Catch::Contains("points_m"));
    folder.write("my.json",
                 scene_of(R"({"name": "a", "shape": "polyhedron", "obj_file": "none.obj", "mass_kg": 1})"));
    CHECK_THROWS_WITH(
        read_scene_file(folder / "my.json"),
        Catch::Contains("bodies[0].obj_file \"none.obj\": must be a Wavefront OBJ file with vertices"));
}

TEST_CASE("density times volume is the mass of boxes, balls and polyhedra") {
    const SceneDescription scene = read(scene_of(R"(
        {"name": "box", "shape": "box", "size_m": [1, 2, 3], "density_kg_per_m3": 10},
        {"name": "ball", "shape": "sphere", "radius_m": 3, "density_kg_per_m3": 10},
        {"name": "simplex", "shape": "polyhedron", "points_m": [[0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3]],
         "density_kg_per_m3": 10})"));
    CHECK(*scene.bodies[0].mass == Approx(60));
    CHECK(*scene.bodies[1].mass == Approx(1130.9733552923256));
    CHECK(*scene.bodies[2].mass == Approx(10));
}

TEST_CASE("wrong polyhedra are refused with the path inside the file and what is allowed") {
    const auto with = [](const std::string& points) {
        return R"({"name": "a", "mass_kg": 1, "shape": "polyhedron", "points_m": [)" + points + "]}";
    };
    CHECK_THAT(refusal(with("[0, 0, 0], [1, 0, 0], [0, 1, 0]")),
               Catch::Contains("must be 4 points or more, and these are 3 points"));
    CHECK_THAT(refusal(with("[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]")),
               Catch::Contains("must be points with a volume, and these are points in a plane"));
    CHECK_THAT(refusal(with("[0, 0, 0], [1, 1, 0], [2, 2, 0], [3, 3, 0]")),
               Catch::Contains("must be points with a volume, and these are points on a line"));
    CHECK(refusal(with("[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0]")) ==
          "bodies[0].points_m[4] [1,0,0]: must be another point than number 1");
    CHECK(refusal(with("[0, 0, 0], [1, 0], [0, 1, 0], [0, 0, 1]")) ==
          "bodies[0].points_m[1] [1,0]: must be three numbers [x, y, z]");
    CHECK_THAT(refusal(R"({"name": "a", "mass_kg": 1, "shape": "polyhedron"})"),
               Catch::Contains("bodies[0].points_m: is missing"));
    CHECK_THAT(refusal(R"({"name": "a", "mass_kg": 1, "radius_m": 1, )" + wedge + "}"),
               Catch::Contains("left out: a polyhedron has points_m or obj_file"));
    CHECK_THAT(refusal(R"({"name": "a", "mass_kg": 1, "obj_file": "b.obj", )" + wedge + "}"),
               Catch::Contains("left out where obj_file is given"));
    CHECK_THAT(refusal(R"({"name": "a", "mass_kg": 1, "density_kg_per_m3": 1, )" + wedge + "}"),
               Catch::Contains("left out where mass_kg is given"));
    CHECK_THAT(refusal(R"({"name": "a", "static": true, "density_kg_per_m3": 1, )" + wedge + "}"),
               Catch::Contains("left out of a static body"));
    CHECK_THAT(refusal(R"({"name": "a", "mass_kg": 1, "shape": "sphere", "radius_m": 1, "points_m": []})"),
               Catch::Contains("left out: a sphere has radius_m"));
}

TEST_CASE("a static polyhedron is passed by what gets through the middle of it, and not by what goes past it") {
    const SceneDescription scene = read(scene_of(R"({"name": "a", "static": true, "shape": "polyhedron",
        "points_m": [[-1, -1, -1], [1, -1, -1], [0, 1, -1], [-1, -1, 1], [1, -1, 1], [0, 1, 1]]})",
                                                 R"(, "contacts": true)"));
    const BuiltScene built = build_scene(scene, preset_settings("default"));
    const Obstacles obstacles(built);
    const Vector3 middle = built.world.bodies[0].position;
    CHECK(obstacles.is_passed(middle + Vector3(-3, 0, 0), middle + Vector3(3, 0, 0)));
    CHECK(obstacles.is_passed(middle + Vector3(0, 3, 0), middle));
    CHECK(!obstacles.is_passed(middle + Vector3(-3, 1.2, 0), middle + Vector3(3, 1.2, 0)));
    CHECK(!obstacles.is_passed(middle + Vector3(-3, 0, 0), middle + Vector3(-0.8, 0, 0)));
}
