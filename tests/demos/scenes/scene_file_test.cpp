// Scene files: round trips, the examples, the schema, and the messages for wrong files.
#include "demos/scenes/scene_file.h"

#include "demos/base/text/errors.h"
#include "demos/base/text/json.h"
#include "demos/options/choices.h"
#include "demos/runs/scene.h"
#include "demos/scenes/catalogue.h"
#include "tests/catch.h"
#include "tests/demos/program.h"
#include "tests/demos/scenes/said_of.h"
#include "tests/settings.h"

#include <algorithm>

using namespace pushfactor;
using namespace pushfactor::demos;
using tests::Folder;
using tests::said_of;

namespace {

const std::string ball = R"({"name": "ball", "shape": "sphere", "radius_m": 0.5, "mass_kg": 1})";

std::string scene_of(const std::string& bodies, const std::string& rest = "") {
    return R"({"version": 1, "bodies": [)" + bodies + "]" + rest + "}";
}

std::string hash_in(const std::string& summary) {
    const auto at = summary.find("state_hash");
    return summary.substr(at, 32);
}

}  // namespace

TEST_CASE("a built-in scene and its file run to the same state, options included") {
    for (const SceneEntry& entry : catalogue()) {
        const Folder folder;
        const std::string name(entry.name);
        const std::string options = " --seconds 1.5 --dt 1/120 --beta 0.3 ";
        REQUIRE(tests::shell(folder, "pushfactor scene " + name + options + "> my.json").status == 0);
        const std::string built_in = tests::shell(folder, "pushfactor run " + name + options).out;
        const std::string from_file = tests::shell(folder, "pushfactor run my.json").out;
        CHECK(hash_in(built_in).size() == 32);
        CHECK(hash_in(from_file) == hash_in(built_in));
        const Json own = parse_json(built_in), of_file = parse_json(from_file);
        for (const char* const key : {"outcome", "lean_time_s", "fall_time_s", "heights_m"}) {
            INFO(name << " " << key);
            CHECK(own.value(key, Json()) == of_file.value(key, Json()));
        }
        // And reading and writing it again gives the same file.
        REQUIRE(tests::shell(folder, "pushfactor scene my.json > again.json").status == 0);
        CHECK(folder.read("again.json") == folder.read("my.json"));
    }
}

TEST_CASE("the command line comes before the options of a scene file") {
    const Folder folder;
    tests::shell(folder, "pushfactor scene stack --beta 0.3 --seconds 1 > my.json");
    CHECK_THAT(tests::shell(folder, "pushfactor run my.json").out, Catch::Contains("\"beta\": 0.3"));
    CHECK_THAT(tests::shell(folder, "pushfactor run my.json --beta 0.4").out, Catch::Contains("\"beta\": 0.4"));
    CHECK_THAT(tests::shell(folder, "pushfactor run my.json --count 3").err,
               Catch::Contains("has no such parameter"));
}

TEST_CASE("the worked examples run and stay finite") {
    int examples = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(PUSHFACTOR_SOURCE_DIR) + "/assets/scenes")) {
        if (entry.path().string().ends_with(".schema.json")) continue;
        INFO(entry.path());
        ++examples;
        const tests::Ended ended = tests::run_program("run '" + entry.path().string() + "' --seconds 3");
        CHECK(ended.status == 0);
        CHECK_THAT(ended.out,
                   !Catch::Contains("\"outcome\": \"fly\"") && !Catch::Contains("\"outcome\": \"tunnel\""));
    }
    CHECK(examples >= 4);
}

TEST_CASE("the schema knows the keys that the reader knows, and no other") {
    const Json schema =
        parse_json(tests::read_file(std::string(PUSHFACTOR_SOURCE_DIR) + "/assets/scenes/scene.schema.json"));
    for (const auto& [part, keys] : scene_file_keys()) {
        const Json& object = part == "scene" ? schema : schema["$defs"][part];
        std::vector<std::string> in_schema;
        for (const auto& [key, value] : object["properties"].items()) in_schema.push_back(key);
        std::vector<std::string> in_reader = keys;
        std::sort(in_schema.begin(), in_schema.end());
        std::sort(in_reader.begin(), in_reader.end());
        INFO(part);
        CHECK(in_schema == in_reader);
    }
}

TEST_CASE("what a file does not mention is not constructed") {
    const Folder folder;
    folder.write("my.json", scene_of(ball));
    const BuiltScene scene = build_scene(read_scene_file(folder / "my.json"), tests::awake_settings("default"));
    CHECK(scene.world.bodies.size() == 1);
    CHECK(scene.world.forces.empty());
    CHECK(scene.world.constraints.empty());
    CHECK(scene.world.solver == nullptr);
    CHECK(scene.contacts == nullptr);
}

TEST_CASE("wrong files are refused with the path inside them, the value and what is allowed") {
    CHECK_THAT(said_of("{"), Catch::Contains("is not JSON"));
    // A parser may take a zero byte for the end.
    CHECK_THAT(said_of(std::string(R"({"version": 1})") + '\0'), Catch::Contains("is not JSON: byte 15 is zero"));
    for (const char* name : {"../up", "/etc/x", "..", ""}) {
        CHECK_THAT(said_of(R"({"version": 1, "bodies": [], "name": ")" + std::string(name) + "\"}"),
                   Catch::Contains("a name without slashes"));
    }
    CHECK_THAT(said_of("[]"), Catch::Contains("must be an object"));
    CHECK_THAT(said_of(R"({"version": 1})"), Catch::Contains("bodies: is missing"));
    CHECK_THAT(said_of(R"({"version": 2, "bodies": []})"), Catch::Contains("version 2: must be 1"));
    CHECK_THAT(said_of(scene_of("", R"(, "contats": true)")),
               Catch::Contains("contats: unknown key") && Catch::Contains("contacts?"));
    CHECK_THAT(said_of(scene_of(R"({"name": "a", "shape": "sphere", "radius": 1})")),
               Catch::Contains("bodies[0].radius: unknown key") && Catch::Contains("radius_m?"));
    CHECK_THAT(said_of(scene_of(R"({"name": 5, "shape": "sphere"})")),
               Catch::Contains("bodies[0].name 5: must be a string"));
    CHECK_THAT(said_of(scene_of(R"({"name": "a", "shape": "cube"})")),
               Catch::Contains("must be one of box, sphere, plane, polyhedron"));
    CHECK_THAT(said_of(scene_of(R"({"name": "a", "shape": "sphere", "radius_m": 1, "mass_kg": -1})")),
               Catch::Contains("bodies[0].mass_kg -1: must be a number from 1e-100 to 1e+100"));
    CHECK_THAT(said_of(scene_of(R"({"name": "a", "shape": "sphere", "radius_m": 1})")),
               Catch::Contains("bodies[0].mass_kg: is missing"));
    CHECK_THAT(said_of(scene_of(R"({"name": "a", "shape": "box", "size_m": [1, 0, 1], "mass_kg": 1})")),
               Catch::Contains("bodies[0].size_m[1] 0: must be a number from 1e-50 to 1e+50"));
    CHECK_THAT(said_of(scene_of(R"({"name": "a", "shape": "sphere", "radius_m": NaN, "mass_kg": 1})")),
               Catch::Contains("bodies[0].radius_m NaN: must be a finite number"));
    CHECK_THAT(said_of(scene_of(R"({"name": "a", "shape": "sphere", "radius_m": 1e999, "mass_kg": 1})")),
               Catch::Contains("my.json"));
    CHECK_THAT(said_of(scene_of(R"({"name": "a", "shape": "plane", "mass_kg": 1})")),
               Catch::Contains("a plane is static"));
    CHECK_THAT(said_of(scene_of(R"({"name": "a", "shape": "plane", "orientation_wxyz": [1, 1, 0, 0]})")),
               Catch::Contains("of length 1"));
    CHECK_THAT(said_of(scene_of(ball + "," + ball)),
               Catch::Contains("bodies[1].name \"ball\": must be a name that no other body has"));
    CHECK_THAT(said_of(scene_of(R"({"name": "world", "shape": "plane"})")), Catch::Contains("other than world"));
    CHECK_THAT(
        said_of(scene_of(ball, R"(, "distance_constraints": [{"a": {"body": "world"}, "b": {"body": "bell"}}])")),
        Catch::Contains("distance_constraints[0].b.body \"bell\": must be the name of a body"));
    CHECK_THAT(
        said_of(scene_of(ball, R"(, "distance_constraints": [{"a": {"body": "ball"}, "b": {"body": "ball"}}])")),
        Catch::Contains("another body than a"));
    CHECK_THAT(said_of(scene_of(ball, R"(, "forces": [{"body": "world", "force_n": [0, 1, 0]}])")),
               Catch::Contains("forces[0].body"));
    CHECK_THAT(said_of(scene_of(ball, R"(, "options": {"betta": 1})")),
               Catch::Contains("options.betta: unknown key"));
    CHECK_THAT(said_of(scene_of(ball, R"(, "colours": {"ball": "pink"})")),
               Catch::Contains("colours.ball \"pink\": must be one of"));
    CHECK_THAT(said_of(scene_of(ball, R"(, "camera": {"eye_m": [0, 0, 0], "target_m": [0, 0, 0]})")),
               Catch::Contains("another point than eye_m"));
    CHECK(said_of(scene_of(ball)) == "accepted");
}

TEST_CASE("a bad option in a scene file names the file and the option, and status 2 is the end") {
    const Folder folder;
    folder.write("my.json", scene_of(ball, R"(, "options": {"beta": 7})"));
    const tests::Ended ended = tests::shell(folder, "pushfactor run my.json");
    CHECK(ended.status == 2);
    CHECK_THAT(ended.err, Catch::Contains("my.json: options.beta 7: must be a number from 0 to 1"));
    CHECK(tests::shell(folder, "pushfactor run missing.json").status == 2);
}

TEST_CASE("a file of more bodies than the program takes is refused, not crashed on") {
    std::string bodies;
    for (int i = 0; i < 100001; ++i) {
        bodies += (i ? "," : "") + std::string(R"({"name":")") + std::to_string(i) + R"(","shape":"plane"})";
    }
    CHECK_THAT(said_of(scene_of(bodies)), Catch::Contains("must be at most 100000 bodies"));
}

TEST_CASE("a scene that leaves the finite numbers ends with status 5, and names body, quantity and step") {
    const Folder folder;
    folder.write(
        "my.json",
        scene_of(
            R"({"name": "a", "shape": "sphere", "radius_m": 1, "mass_kg": 1,
                                         "velocity_m_per_s": [0, 1e308, 0]},
                                        {"name": "b", "shape": "sphere", "radius_m": 1, "mass_kg": 1e100})",
            R"(, "forces": [{"body": "b", "force_n": [0, 0, 1e308]}, {"body": "b", "force_n": [0, 0, 1e308]}])"));
    const tests::Ended ended = tests::shell(folder, "pushfactor run my.json");
    CHECK(ended.status == 5);
    CHECK_THAT(ended.err, Catch::Contains("body b: ") && Catch::Contains("is not finite after step 1 "));
    CHECK(ended.out.empty());
}

TEST_CASE("a moved body of a file moves as the file says, and the file of the file is the file") {
    const std::vector<std::pair<std::string, engine::Vector3>> motions{
        {R"({"velocity_m_per_s": [1, 2, 3], "from_s": 0.25, "until_s": 0.5})", {0.25, 0.5, 0.75}},
        {R"({"amplitude_m": 0.3, "direction": [0, 0, 2], "frequency_hz": 0.5, "phase_deg": -90})", {0, 0, 0.6}},
        {R"({"poses": [{"time_s": 0.5, "position_m": [2, 0, 0]}, {"time_s": 1, "orientation_wxyz": [0, 1, 0, 0]}]})",
         {2, 0, 0}}};
    for (const auto& [motion, end] : motions) {
        const Folder folder;
        folder.write("my.json", scene_of(R"({"name": "table", "shape": "box", "size_m": [1, 1, 1], "static": true,
                                             "motion": )" +
                                         motion + "}"));
        BuiltScene scene = build_scene(read_scene_file(folder / "my.json"), tests::awake_settings("default"));
        CHECK(scene.world.constraints.empty());
        for (int i = 0; i < 60; ++i) scene.step(scene.world, 1.0 / 60.0);
        INFO(motion);
        CHECK((scene.world.bodies[0].position - end).norm() < 1e-9);
        const std::string text = scene_file_text(read_scene_file(folder / "my.json"));
        folder.write("again.json", text);
        CHECK(scene_file_text(read_scene_file(folder / "again.json")) == text);
    }
}

TEST_CASE("a wrong motion is refused with its path in the file, the value and what is allowed") {
    const auto said = [](const std::string& motion, const std::string& fixed = R"("static": true)") {
        return said_of(scene_of(R"({"name": "table", "shape": "box", "size_m": [1, 1, 1], )" + fixed +
                                R"(, "motion": )" + motion + "}"));
    };
    CHECK(said(R"({"velocity_m_per_s": [0, 1, 0]})") == "accepted");
    CHECK_THAT(said(R"({"velocity_m_per_s": [0, 1, 0]})", R"("mass_kg": 1)"),
               Catch::Contains("bodies[0].motion") && Catch::Contains("left out of a body with a mass"));
    CHECK_THAT(said("{}"), Catch::Contains("must be given velocity_m_per_s, angular_velocity_rad_per_s"));
    CHECK_THAT(said(R"({"speed": 1})"), Catch::Contains("bodies[0].motion.speed: unknown key"));
    CHECK_THAT(said(R"({"velocity_m_per_s": [0, 1, 0], "from_s": 2, "until_s": 1})"),
               Catch::Contains("motion.until_s 1: must be a number from 2 to 1000000000"));
    CHECK_THAT(said(R"({"amplitude_m": 1, "direction": [0, 0, 0], "frequency_hz": 1})"),
               Catch::Contains("motion.direction [0,0,0]: must be a vector that has a direction"));
    CHECK_THAT(said(R"({"amplitude_m": 1, "direction": [0, 1, 0], "frequency_hz": 0})"),
               Catch::Contains("motion.frequency_hz 0: must be"));
    CHECK_THAT(said(R"({"amplitude_m": 1, "direction": [0, 1, 0]})"), Catch::Contains("frequency_hz: is missing"));
    CHECK_THAT(said(R"({"amplitude_m": 1, "velocity_m_per_s": [0, 1, 0]})"),
               Catch::Contains("must be left out of a motion to and fro"));
    CHECK_THAT(said(R"({"poses": []})"), Catch::Contains("motion.poses []: must be one pose at least"));
    CHECK_THAT(said(R"({"poses": [{"time_s": 0}]})"), Catch::Contains("poses[0].time_s 0: must be above 0"));
    CHECK_THAT(said(R"({"poses": [{"time_s": 1}, {"time_s": 1}]})"),
               Catch::Contains("poses[1].time_s 1: must be above that of the pose before"));
    CHECK_THAT(said(R"({"poses": [{"time_s": 1}], "until_s": 1})"), Catch::Contains("each pose has its time_s"));
    const std::string with_rattle = R"({"version": 1, "options": {"scheme": "rattle"}, "bodies": [
        {"name": "table", "shape": "plane", "motion": {"velocity_m_per_s": [0, 1, 0]}}]})";
    const Folder folder;
    folder.write("my.json", with_rattle);
    const tests::Ended ended = tests::shell(folder, "pushfactor run my.json --seconds 0.1");
    CHECK(ended.status == 2);
    CHECK_THAT(ended.err, Catch::Contains("auto or whole for a scene with moved bodies"));
}

TEST_CASE("a stack that falls has fallen, from its name, its file and its saved state") {
    const Folder folder;
    const std::string run = " --preset paper --seconds 71";
    REQUIRE(tests::shell(folder, "pushfactor scene stack" + run + " > my.json").status == 0);
    const Json own = parse_json(tests::shell(folder, "pushfactor run stack" + run).out);
    REQUIRE(own["outcome"] == "fall");
    const Json of_file = parse_json(tests::shell(folder, "pushfactor run my.json").out);
    REQUIRE(tests::shell(folder, "pushfactor run my.json --seconds 60 --save-state state.json").status == 0);
    const Json resumed = parse_json(tests::shell(folder, "pushfactor run state.json --seconds 11").out);
    for (const char* const key : {"outcome", "heights_m"}) {
        CHECK(of_file[key] == own[key]);
        CHECK(resumed[key] == own[key]);
    }
    CHECK(of_file["fall_time_s"] == own["fall_time_s"]);
    CHECK(of_file["lean_time_s"] == own["lean_time_s"]);
}

TEST_CASE("an unknown key is answered with the nearest one or all, and no force acts on a static body") {
    CHECK_THAT(said_of(scene_of(ball, R"(, "long_box": 1)")),
               Catch::Contains("long_box: unknown key; there are version, name, gravity_m_per_s2, bodies"));
    CHECK_THAT(said_of(scene_of(ball, R"(, "options": {"wherever": 1})")),
               Catch::Contains("options.wherever: unknown key; there are preset, seconds"));
    CHECK_THAT(
        said_of(scene_of(R"({"name": "ground", "shape": "plane"})",
                         R"(, "forces": [{"body": "ground", "force_n": [0, 1, 0]}])")),
        Catch::Contains("forces[0].body \"ground\": must be a body with a mass: no force moves a static one"));
    const Folder folder;
    folder.write("my.json",
                 scene_of(R"({"name": "long box", "shape": "box", "size_m": [1e40, 1, 1], "mass_kg": 1})"));
    tests::check_refused(folder, "pushfactor run my.json",
                         "size, mass and velocity of long box together: must be less extreme");
}
