// Polyhedra in scene files: points, OBJ files, densities, what is refused, and what is written.
#include "demos/base/text/errors.h"
#include "demos/base/text/json.h"
#include "demos/options/choices.h"
#include "demos/runs/obstacles.h"
#include "demos/runs/simulation.h"
#include "demos/scenes/scene_file.h"
#include "tests/catch.h"
#include "tests/demos/program.h"
#include "tests/engine/collision/hulls.h"
#include "tests/settings.h"

#include <algorithm>

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

// A box of (1, 0.4, 0.6) m, or the hull of its corners, in a scene file: the file's frame of the body is turned by
// `turn` and then moved by `shift` from the frame of the box.
struct FrameOfFile {
    engine::Quaternion turn = engine::Quaternion::Identity();
    Vector3 shift = Vector3::Zero();
    bool is_polyhedron = false;

    static Json numbers(const Vector3& v) { return {v.x(), v.y(), v.z()}; }
    static Json numbers(const engine::Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }

    Json point(const Vector3& of_box) const { return numbers(Vector3(turn * of_box + shift)); }
    Json direction(const Vector3& of_box) const { return numbers(Vector3(turn * of_box)); }
    engine::Quaternion turned(const engine::Quaternion& box) const { return box * turn.conjugate(); }

    Json place(const Vector3& position, const engine::Quaternion& orientation) const {
        const engine::Quaternion own = turned(orientation);
        return {{"position_m", numbers(Vector3(position - own * shift))}, {"orientation_wxyz", numbers(own)}};
    }
    Json body(const std::string& name, const Vector3& position, const engine::Quaternion& orientation) const {
        Json json = place(position, orientation);
        json["name"] = name;
        if (!is_polyhedron) {
            json["shape"] = "box";
            json["size_m"] = {1, 0.4, 0.6};
            return json;
        }
        json["shape"] = "polyhedron";
        for (const Vector3& corner : tests::box_points({0.5, 0.2, 0.3})) json["points_m"].push_back(point(corner));
        return json;
    }
};

// Whatever a file says of a body in its frame: a moved body hangs up a second one by a hinge, on which a third one
// hangs by a bar, pushed and turned in its own frame.
std::string hanging_boxes(const FrameOfFile& frame) {
    const engine::Quaternion straight = engine::Quaternion::Identity();
    const engine::Quaternion aslant(Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()));
    Json top = frame.body("top", {0, 5, 0}, aslant);
    top["static"] = true;
    top["motion"]["poses"] = {frame.place({0.5, 5, 0}, straight), frame.place({0, 5.5, 0.5}, aslant)};
    top["motion"]["poses"][0]["time_s"] = 0.5;
    top["motion"]["poses"][1]["time_s"] = 1.2;
    Json middle = frame.body("middle", {0, 4, 0}, straight), low = frame.body("low", {0, 3, 0}, aslant);
    middle["mass_kg"] = 2;
    low["mass_kg"] = 1;
    Json scene{{"version", 1}, {"bodies", {top, middle, low}}};
    const Vector3 over(0.1, 0.5, 0.2);  // from the middle to the hinge
    const Vector3 of_top = aslant.conjugate() * Vector3(0.1, -0.5, 0.2);
    scene["joints"] = {
        {{"type", "hinge"},
         {"a", {{"body", "top"}, {"point_m", frame.point(of_top)}}},
         {"b", {{"body", "middle"}, {"point_m", frame.point(over)}}},
         {"axis", frame.direction(aslant.conjugate() * Vector3::UnitZ())},
         {"zero_wxyz", frame.numbers(engine::Quaternion(frame.turn * aslant.conjugate() * frame.turn.conjugate()))},
         {"limits_rad", {-0.05, 0.3}}}};
    scene["distance_constraints"] = {{{"a", {{"body", "middle"}, {"point_m", frame.point({0.4, -0.2, 0})}}},
                                      {"b", {{"body", "low"}, {"point_m", frame.point({0, 0.2, 0.1})}}}}};
    scene["forces"] = {{{"body", "low"},
                        {"frame", "body"},
                        {"force_n", frame.direction({3, 0, 1})},
                        {"point_m", frame.point({0.5, 0, 0})},
                        {"torque_n_m", frame.direction({0, 0.5, 0})}}};
    return json_text(scene, -1);
}

// World places of the eight corners of each body after some steps, in any order.
using Corners = std::vector<std::vector<Vector3>>;
Corners corners_after(const std::string& text, long steps) {
    const SceneDescription scene = read(text);
    Settings settings = tests::awake_settings("exact");
    settings.rotation = Rotation::exponential;  // splitting depends on the order of the principal axes
    Simulation run(build_scene(scene, settings), settings);
    while (run.sample().step < steps) run.advance();
    Corners corners;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const auto* const polyhedron = std::get_if<PolyhedronShape>(&scene.bodies[i].shape);
        std::vector<Vector3>& own = corners.emplace_back(tests::box_points({0.5, 0.2, 0.3}));
        if (polyhedron) own.assign(polyhedron->points().begin(), polyhedron->points().end());
        const engine::Body& body = run.scene().world.bodies[i];
        for (Vector3& corner : own) corner = body.position + body.orientation * corner;
    }
    return corners;
}

double largest_distance(const Corners& from, const Corners& to) {
    double largest = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        for (const Vector3& corner : from[i]) {
            double nearest = std::numeric_limits<double>::infinity();
            for (const Vector3& other : to[i]) nearest = std::min(nearest, (corner - other).norm());
            largest = std::max(largest, nearest);
        }
    }
    return largest;
}

}  // namespace

TEST_CASE("joints, axes, bars, forces and motions of a polyhedron are in the frame of its points") {
    const auto expected = corners_after(hanging_boxes({}), 90);
    const engine::Quaternion turn(Eigen::AngleAxisd(1.1, Vector3(3, -1, 2).normalized()));
    for (const FrameOfFile& frame : {FrameOfFile{.is_polyhedron = true},
                                     FrameOfFile{.turn = turn, .shift = {4, -2, 7}, .is_polyhedron = true}}) {
        CHECK(largest_distance(expected, corners_after(hanging_boxes(frame), 90)) < 1e-9);
    }
}

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

TEST_CASE("what is wrong with an OBJ file is named with its line and its word") {
    const Folder folder;
    folder.write("my.json",
                 scene_of(R"({"name": "a", "shape": "polyhedron", "obj_file": "it.obj", "mass_kg": 1})"));
    const std::vector<std::pair<const char*, const char*>> cases = {
        {"v 0 0 0\nv 1,5 0,0 0,0\n", "line 2 \"1,5\": must be a vertex of three numbers with decimal points"},
        {"v 0 0 nan\n", "line 1 \"nan\""},
        {"v 0 0\n", "line 1 a vertex with too few words"},
        {"v 0 0 0 red\n", "line 1 \"red\": must be a number"},
        {"f 1 2 3\n", "with vertices"},
        {"version https://git-lfs.github.com/spec/v1\n", "is a Git LFS pointer and not the file"},
    };
    for (const auto& [text, fault] : cases) {
        folder.write("it.obj", text);
        CHECK_THROWS_WITH(read_scene_file(folder / "my.json"),
                          Catch::Contains("bodies[0].obj_file \"it.obj\"") && Catch::Contains(fault));
    }
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
    const BuiltScene built = build_scene(scene, tests::awake_settings("default"));
    const Obstacles obstacles(built);
    const Vector3 middle = built.world.bodies[0].position;
    CHECK(obstacles.is_passed(middle + Vector3(-3, 0, 0), middle + Vector3(3, 0, 0)));
    CHECK(obstacles.is_passed(middle + Vector3(0, 3, 0), middle));
    CHECK(!obstacles.is_passed(middle + Vector3(-3, 1.2, 0), middle + Vector3(3, 1.2, 0)));
    CHECK(!obstacles.is_passed(middle + Vector3(-3, 0, 0), middle + Vector3(-0.8, 0, 0)));
}
