// Bad values in every field of a scene file and every option (not a number, infinite, zero, negative): refused with
// the field's name, before anything runs.
#include "demos/base/text/errors.h"
#include "demos/base/text/json.h"
#include "demos/options/choices.h"
#include "demos/options/frame_options.h"
#include "demos/options/simulation_options.h"
#include "demos/runs/scene.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/scene_file.h"
#include "engine/base/invalid_input.h"
#include "tests/catch.h"
#include "tests/demos/program.h"
#include "tests/demos/scenes/said_of.h"
#include "tests/settings.h"

#include <algorithm>
#include <map>
#include <set>

using namespace pushfactor;
using namespace pushfactor::demos;
using tests::Folder;
using tests::said_of;

namespace {

// A scene with one of everything that a scene file can hold.
const char* const everything = R"({
    "$schema": "scene.schema.json", "version": 1, "name": "everything", "gravity_m_per_s2": [0, -10, 0],
    "bodies": [
        {"name": "ground", "shape": "plane", "friction": 0.5},
        {"name": "box", "shape": "box", "size_m": [1, 1, 1], "mass_kg": 1, "position_m": [0, 2, 0],
         "moments_of_inertia_kg_m2": [1, 1, 1],
         "orientation_wxyz": [1, 0, 0, 0], "velocity_m_per_s": [0, 0, 0], "angular_velocity_rad_per_s": [0, 0, 0],
         "friction": 0.5, "restitution": 0.5, "material": "oak", "group": "pile", "surface_velocity_m_per_s": [0, 0, 0],
         "surface_from_s": 0},
        {"name": "ball", "shape": "sphere", "radius_m": 0.5, "mass_kg": 1, "position_m": [3, 2, 0],
         "linear_momentum_kg_m_per_s": [0, 0, 0], "angular_momentum_kg_m2_per_s": [0, 0, 0]},
        {"name": "block", "shape": "box", "size_m": [1, 1, 1], "static": true, "position_m": [0, 9, 0],
         "motion": {"velocity_m_per_s": [1, 0, 0], "angular_velocity_rad_per_s": [0, 1, 0], "from_s": 1, "until_s": 2}},
        {"name": "wedge", "shape": "polyhedron", "points_m": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
         "density_kg_per_m3": 10, "position_m": [9, 9, 9]},
        {"name": "shaker", "shape": "polyhedron", "obj_file": "tetrahedron.obj", "static": true,
         "position_m": [-9, 9, 9], "motion": {"amplitude_m": 0.1, "direction": [0, 1, 0], "frequency_hz": 2,
         "phase_deg": -90}},
        {"name": "lift", "shape": "sphere", "radius_m": 0.5, "static": true, "position_m": [-9, 9, -9],
         "measured_of": "ball", "motion": {"poses": [{"time_s": 1, "position_m": [-9, 8, -9], "orientation_wxyz": [1, 0, 0, 0]}]}}],
    "distance_constraints": [
        {"a": {"body": "box", "point_m": [0, 0, 0]}, "b": {"body": "ball", "point_m": [0, 0, 0]}, "length_m": 3,
         "acts": "pulls", "max_force_n": 100},
        {"a": {"body": "box"}, "b": {"body": "ball"}, "length_m": 3,
         "spring": {"stiffness_n_per_m": 10, "damping_n_s_per_m": 1}}],
    "joints": [
        {"type": "hinge", "a": {"body": "box"}, "b": {"body": "ball"}, "axis": [0, 0, 1], "zero_wxyz": [1, 0, 0, 0],
         "motor": {"speed_rad_per_s": 1, "max_torque_n_m": 2}, "limits_rad": [-1, 1], "collide": true},
        {"type": "hinge", "a": {"body": "wedge"}, "b": {"body": "ball"}, "axis": [0, 0, 1],
         "motor": {"target_angle_rad": 1, "stiffness_n_m_per_rad": 20, "damping_n_m_s_per_rad": 3}}],
    "forces": [{"body": "ball", "force_n": [1, 0, 0], "torque_n_m": [0, 0, 1], "point_m": [0, 0, 0], "frame": "body",
                "from_s": 0, "until_s": 1}],
    "contacts": true,
    "no_contacts": [["box", "block"]],
    "material_pairs": [{"a": "oak", "b": "oak", "friction": 0.4, "restitution": 0.1}],
    "standing": {"side_m": 1, "rest_heights_m": [0.5, 1.5, 2.5]},
    "state": {"time_s": 0.5, "substeps": 1, "solved_exactly": false, "kept_steps": 0,
              "warm_start": [{"bodies": ["box"], "solved_exactly": true, "kept_steps": 0,
                              "exact_debt_multiply_adds": 100, "exact_failures": 1}],
              "distance_forces_n": [[0, 0], [0, 0]],
              "force_rate_per_s": 5, "joint_angles_rad": [0.5, 0],
              "joint_forces_n": [[[0, 0], [0, 0], [0, 0], [0, 0], [0, 0], [0, 0], [0, 0], [0, 0]],
                                 [[0, 0], [0, 0], [0, 0], [0, 0], [0, 0], [0, 0]]], "contact_forces": [{"a": "ground", "b": "box", "points": [
                  {"feature": 1, "position_m": [0, 0, 0], "normal_n": [1, 1], "friction_first_n": [0, 0, 0],
                   "friction_last_n": [0, 0, 0]}]}],
              "places": [{"body": "box", "wide": true, "still_s": 0.5, "here_s": 0.5, "position_m": [0, 2, 0],
                          "orientation_wxyz": [1, 0, 0, 0], "angular_momentum_kg_m2_per_s": [0, 0, 0]}],
              "at_rest": [["box"]]},
    "options": {"seconds": 0.1},
    "camera": {"eye_m": [0, 2, 9], "target_m": [0, 1, 0], "field_of_view_deg": 40, "floor_m": 0},
    "colours": {"box": "blue"}
})";

// A key of the file, and the values that it refuses in addition to those that every key refuses. Values as JSON.
struct Field {
    std::string part, key;
    std::string pointer;  // where `everything` has it
    std::vector<std::string> refused;
};

const std::vector<std::string> no_numbers{"\"1\"", "null", "true", "[]", "{}"};
const std::vector<std::string> no_positive{"0", "-1", "1e-320"};
const std::vector<std::string> no_vectors{"1", "[0, 0]", "[0, 0, 0, 0]", "[0, \"0\", 0]", "[0, null, 0]"};
const std::vector<std::string> no_sizes{"1", "[1, 1]", "[1, 0, 1]", "[1, 1, -1]", "[1, 1e300, 1]"};
const std::vector<std::string> no_words{"1", "\"\"", "\"wrong\"", "[]"};
const std::vector<std::string> no_switches{"0", "1", "\"on\"", "null"};
const std::vector<std::string> no_lists{"1", "{}", "\"wrong\""};
const std::vector<std::string> no_objects{"1", "[]", "{\"wrong\": 1}"};

std::vector<std::string> both(std::vector<std::string> some, const std::vector<std::string>& more) {
    some.insert(some.end(), more.begin(), more.end());
    return some;
}

const std::vector<Field> fields{
    {"scene", "$schema", "/$schema", {"1", "null", "[]"}},
    {"scene", "version", "/version", both(no_numbers, {"0", "2", "-1", "1.5"})},
    {"scene", "name", "/name", {"1", "\"\"", "\"../up\"", "\".hidden\""}},
    {"scene", "gravity_m_per_s2", "/gravity_m_per_s2", no_vectors},
    {"scene", "bodies", "/bodies", no_lists},
    {"scene", "distance_constraints", "/distance_constraints", no_lists},
    {"scene", "joints", "/joints", no_lists},
    {"scene", "forces", "/forces", no_lists},
    {"scene", "contacts", "/contacts", no_switches},
    {"scene", "no_contacts", "/no_contacts",
     both(no_lists, {"[1]", "[[\"box\"]]", "[[\"box\", \"wrong\"]]", "[[\"box\", \"box\"]]"})},
    {"scene", "material_pairs", "/material_pairs", both(no_lists, {"[1]", "[{}]"})},
    {"scene", "standing", "/standing", both(no_objects, {"{}"})},
    {"standing", "side_m", "/standing/side_m", both(no_numbers, no_positive)},
    {"standing", "rest_heights_m", "/standing/rest_heights_m", both(no_lists, {"[]", "[1, 2]", "[1, 2, \"3\"]"})},
    {"scene", "state", "/state", no_objects},
    {"scene", "options", "/options", no_objects},
    {"scene", "camera", "/camera", no_objects},
    {"scene", "colours", "/colours", no_objects},
    {"body", "name", "/bodies/1/name", {"1", "\"\"", "\"world\"", "\"ground\""}},
    {"body", "shape", "/bodies/1/shape", no_words},
    {"body", "size_m", "/bodies/1/size_m", no_sizes},
    {"body", "radius_m", "/bodies/2/radius_m", both(no_numbers, no_positive)},
    {"body", "points_m", "/bodies/4/points_m",
     both(no_lists, {"[]", "[[0, 0, 0], [1, 0, 0], [0, 1, 0]]", "[[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]",
                     "[[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0]]", "[[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]]",
                     "[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, null]]"})},
    {"body", "obj_file", "/bodies/5/obj_file", {"1", "\"\"", "\"wrong.obj\"", "null"}},
    {"body", "density_kg_per_m3", "/bodies/4/density_kg_per_m3", both(no_numbers, no_positive)},
    {"body", "mass_kg", "/bodies/1/mass_kg", both(no_numbers, no_positive)},
    {"body", "static", "/bodies/3/static", no_switches},
    {"body", "motion", "/bodies/3/motion", both(no_objects, {"{}"})},
    {"motion", "velocity_m_per_s", "/bodies/3/motion/velocity_m_per_s", no_vectors},
    {"motion", "angular_velocity_rad_per_s", "/bodies/3/motion/angular_velocity_rad_per_s", no_vectors},
    {"motion", "from_s", "/bodies/3/motion/from_s", both(no_numbers, {"-1"})},
    {"motion", "until_s", "/bodies/3/motion/until_s", both(no_numbers, {"0.5"})},
    {"motion", "amplitude_m", "/bodies/5/motion/amplitude_m", both(no_numbers, {"-1"})},
    {"motion", "direction", "/bodies/5/motion/direction", both(no_vectors, {"[0, 0, 0]"})},
    {"motion", "frequency_hz", "/bodies/5/motion/frequency_hz", both(no_numbers, {"0", "-1"})},
    {"motion", "phase_deg", "/bodies/5/motion/phase_deg", both(no_numbers, {"361"})},
    {"motion", "poses", "/bodies/6/motion/poses", both(no_lists, {"[]", "[1]", "[{}]"})},
    {"pose", "time_s", "/bodies/6/motion/poses/0/time_s", both(no_numbers, {"0", "-1"})},
    {"pose", "position_m", "/bodies/6/motion/poses/0/position_m", no_vectors},
    {"pose", "orientation_wxyz", "/bodies/6/motion/poses/0/orientation_wxyz", {"1", "[1, 0, 0]", "[2, 0, 0, 0]"}},
    {"body", "position_m", "/bodies/1/position_m", no_vectors},
    {"body",
     "orientation_wxyz",
     "/bodies/1/orientation_wxyz",
     {"1", "[1, 0, 0]", "[0, 0, 0, 0]", "[2, 0, 0, 0]", "[1, 0, 0, null]", "[1e200, 0, 0, 0]"}},
    {"body", "velocity_m_per_s", "/bodies/1/velocity_m_per_s", no_vectors},
    {"body", "angular_velocity_rad_per_s", "/bodies/1/angular_velocity_rad_per_s", no_vectors},
    {"body", "linear_momentum_kg_m_per_s", "/bodies/2/linear_momentum_kg_m_per_s", no_vectors},
    {"body", "angular_momentum_kg_m2_per_s", "/bodies/2/angular_momentum_kg_m2_per_s", no_vectors},
    {"body", "friction", "/bodies/1/friction", both(no_numbers, {"-0.1", "101"})},
    {"body", "restitution", "/bodies/1/restitution", both(no_numbers, {"-0.1", "1.0001"})},
    {"body", "material", "/bodies/1/material", {"1", "\"\"", "null"}},
    {"body", "group", "/bodies/1/group", {"1", "\"\"", "null"}},
    {"body", "surface_velocity_m_per_s", "/bodies/1/surface_velocity_m_per_s", no_vectors},
    {"body", "moments_of_inertia_kg_m2", "/bodies/1/moments_of_inertia_kg_m2",
     both(no_vectors, {"[1, 1, 2.1]", "[0, 1, 1]", "[1, 1, -1]"})},
    {"body", "measured_of", "/bodies/6/measured_of", both(no_words, {"\"ground\""})},
    {"body", "surface_from_s", "/bodies/1/surface_from_s", both(no_numbers, {"-1"})},
    {"distance_constraint", "a", "/distance_constraints/0/a", no_objects},
    {"distance_constraint", "b", "/distance_constraints/0/b", no_objects},
    {"distance_constraint", "length_m", "/distance_constraints/0/length_m", both(no_numbers, {"-1", "0"})},
    {"distance_constraint", "acts", "/distance_constraints/0/acts", no_words},
    {"distance_constraint", "max_force_n", "/distance_constraints/0/max_force_n", both(no_numbers, {"0", "-1"})},
    {"distance_constraint", "spring", "/distance_constraints/1/spring",
     both(no_objects, {"{}", "{\"stiffness_n_per_m\": 0}"})},
    {"spring", "stiffness_n_per_m", "/distance_constraints/1/spring/stiffness_n_per_m", both(no_numbers, {"-1"})},
    {"spring", "damping_n_s_per_m", "/distance_constraints/1/spring/damping_n_s_per_m", both(no_numbers, {"-1"})},
    {"joint", "type", "/joints/0/type", both(no_words, {"\"slider\""})},
    {"joint", "a", "/joints/0/a", no_objects},
    {"joint", "b", "/joints/0/b", no_objects},
    {"joint", "axis", "/joints/0/axis", both(no_vectors, {"[0, 0, 0]", "[1e200, 0, 0]"})},
    {"joint", "zero_wxyz", "/joints/0/zero_wxyz", {"1", "[1, 0, 0]", "[2, 0, 0, 0]"}},
    {"joint", "motor", "/joints/0/motor", both(no_objects, {"{}"})},
    {"joint",
     "limits_rad",
     "/joints/0/limits_rad",
     {"1", "[]", "[1]", "[1, -1]", "[-4, 4]", "[7, 8]", "[0, null]"}},
    {"joint", "collide", "/joints/0/collide", no_switches},
    {"motor", "speed_rad_per_s", "/joints/0/motor/speed_rad_per_s", both(no_numbers, {"1e10", "-1e10"})},
    {"motor", "max_torque_n_m", "/joints/0/motor/max_torque_n_m", both(no_numbers, {"0", "-1"})},
    {"motor", "target_angle_rad", "/joints/1/motor/target_angle_rad", both(no_numbers, {"1e7"})},
    {"motor", "stiffness_n_m_per_rad", "/joints/1/motor/stiffness_n_m_per_rad", both(no_numbers, {"-1"})},
    {"motor", "damping_n_m_s_per_rad", "/joints/1/motor/damping_n_m_s_per_rad", both(no_numbers, {"-1"})},
    {"material_pair", "a", "/material_pairs/0/a", no_words},
    {"material_pair", "b", "/material_pairs/0/b", no_words},
    {"material_pair", "friction", "/material_pairs/0/friction", both(no_numbers, {"-0.1", "101"})},
    {"material_pair", "restitution", "/material_pairs/0/restitution", both(no_numbers, {"-0.1", "1.0001"})},
    {"end", "body", "/distance_constraints/0/b/body", both(no_words, {"\"box\""})},  // a bar to itself
    {"end", "point_m", "/distance_constraints/0/a/point_m", no_vectors},
    {"force", "body", "/forces/0/body", both(no_words, {"\"world\""})},
    {"force", "force_n", "/forces/0/force_n", no_vectors},
    {"force", "torque_n_m", "/forces/0/torque_n_m", no_vectors},
    {"force", "point_m", "/forces/0/point_m", no_vectors},
    {"force", "frame", "/forces/0/frame", no_words},
    {"force", "from_s", "/forces/0/from_s", both(no_numbers, {"-1"})},
    {"force", "until_s", "/forces/0/until_s", both(no_numbers, {"-1"})},
    {"state", "time_s", "/state/time_s", both(no_numbers, {"-1"})},
    {"state", "warm_start", "/state/warm_start", no_lists},
    {"warm_start", "bodies", "/state/warm_start/0/bodies", both(no_lists, {"[\"wrong\"]", "[1]"})},
    {"warm_start", "solved_exactly", "/state/warm_start/0/solved_exactly", no_switches},
    {"warm_start", "kept_steps", "/state/warm_start/0/kept_steps", both(no_numbers, {"-1", "0.5"})},
    {"warm_start", "exact_debt_multiply_adds", "/state/warm_start/0/exact_debt_multiply_adds",
     both(no_numbers, {"-1", "1e16"})},
    {"warm_start", "exact_failures", "/state/warm_start/0/exact_failures", both(no_numbers, {"-1", "1001"})},
    {"state", "solved_exactly", "/state/solved_exactly", no_switches},
    {"state", "kept_steps", "/state/kept_steps", both(no_numbers, {"-1", "0.5"})},
    {"state", "substeps", "/state/substeps", both(no_numbers, {"-1", "10001"})},
    {"state", "force_rate_per_s", "/state/force_rate_per_s", both(no_numbers, {"-1"})},
    {"state", "joint_angles_rad", "/state/joint_angles_rad", both(no_lists, {"[1]", "[0, null]", "[0, 1, 2]"})},
    {"state",
     "distance_forces_n",
     "/state/distance_forces_n",
     {"1", "[]", "[1]", "[[0]]", "[[0, 0], [0, 0], [0, 0]]", "[[[0, 0], [0, 0]]]", "[[[0, 0], [0, 0], [0]]]"}},
    {"state",
     "joint_forces_n",
     "/state/joint_forces_n",
     {"1", "[]", "[1]", "[[[0, 0]]]", "[[0, 0, 0, 0, 0, 0, 0, 0]]"}},
    {"state", "contact_forces", "/state/contact_forces", no_lists},
    {"contact_force", "a", "/state/contact_forces/0/a", both(no_words, {"\"box\"", "\"ball\""})},
    {"contact_force", "b", "/state/contact_forces/0/b", both(no_words, {"\"ground\""})},
    {"contact_force", "points", "/state/contact_forces/0/points", no_lists},
    {"contact_force_point", "feature", "/state/contact_forces/0/points/0/feature",
     both(no_numbers, {"-1", "0.5", "4294967296"})},
    {"contact_force_point", "position_m", "/state/contact_forces/0/points/0/position_m", no_vectors},
    {"contact_force_point", "normal_n", "/state/contact_forces/0/points/0/normal_n", {"1", "[1]", "[1, null]"}},
    {"contact_force_point", "friction_first_n", "/state/contact_forces/0/points/0/friction_first_n", no_vectors},
    {"contact_force_point", "friction_last_n", "/state/contact_forces/0/points/0/friction_last_n", no_vectors},
    {"state", "places", "/state/places", no_lists},
    {"state", "at_rest", "/state/at_rest", both(no_lists, {"[\"box\"]", "[[\"wrong\"]]", "[[\"ground\"]]"})},
    {"place", "body", "/state/places/0/body", no_words},
    {"place", "wide", "/state/places/0/wide", {"1", "\"yes\"", "null"}},
    {"place", "still_s", "/state/places/0/still_s", both(no_numbers, {"-1"})},
    {"place", "here_s", "/state/places/0/here_s", both(no_numbers, {"-1"})},
    {"place", "position_m", "/state/places/0/position_m", no_vectors},
    {"place", "orientation_wxyz", "/state/places/0/orientation_wxyz", {"1", "[1, 0, 0]", "[2, 0, 0, 0]"}},
    {"place", "angular_momentum_kg_m2_per_s", "/state/places/0/angular_momentum_kg_m2_per_s", no_vectors},
    {"camera", "eye_m", "/camera/eye_m", both(no_vectors, {"[0, 1, 0]"})},
    {"camera", "target_m", "/camera/target_m", no_vectors},
    {"camera", "field_of_view_deg", "/camera/field_of_view_deg", both(no_numbers, {"0", "-40", "121"})},
    {"camera", "floor_m", "/camera/floor_m", no_numbers},
};

// The error message for `everything` with the text `value` at `pointer`; empty when it is accepted.
std::string said_with(const std::string& pointer, const std::string& value) {
    Json json = parse_json(everything);
    json[Json::json_pointer(pointer)] = "HERE";
    std::string text = json_text(json, -1);
    text.replace(text.find("\"HERE\""), 6, value);
    const Folder folder;
    folder.write("tetrahedron.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\n");
    const std::string said = said_of(text, folder);
    return said == "accepted" ? "" : said;
}

// The name of the field whose value is replaced, or of one that it is part of.
bool names(const std::string& message, const Field& field) {
    return message.find(field.key) != std::string::npos && message.find('\n') == std::string::npos &&
           message.find("my.json: ") != std::string::npos;
}

bool refuses(const SimulationOption& option, const std::string& text) {
    Settings settings = tests::awake_settings("default");
    return !option.set(settings, text);
}

}  // namespace

TEST_CASE("the table has every key of a scene file, and the file with all of them is taken") {
    std::map<std::string, std::set<std::string>> listed, known;
    for (const Field& field : fields) listed[field.part].insert(field.key);
    for (const auto& [part, keys] : scene_file_keys()) known[part].insert(keys.begin(), keys.end());
    CHECK(listed == known);
    CHECK(said_with("/version", "1").empty());
}

TEST_CASE("in every field of a scene file a wrong value is refused by the field's name") {
    for (const Field& field : fields) {
        for (const std::string& value : field.refused) {
            const std::string message = said_with(field.pointer, value);
            INFO(field.pointer << " " << value << ": " << message);
            CHECK(names(message, field));
        }
    }
}

TEST_CASE("in every field of a scene file NaN, infinities and numbers beyond double are refused by its name") {
    for (const Field& field : fields) {
        for (const std::string value : {"NaN", "nan", "Infinity", "-Infinity", "inf", "1e999", "-1e999"}) {
            const std::string message = said_with(field.pointer, value);
            INFO(field.pointer << " " << value << ": " << message);
            CHECK(names(message, field));
            CHECK_THAT(message,
                       Catch::Contains("my.json: ") && Catch::Contains(" " + value + ": must be a finite number"));
        }
    }
    CHECK_THAT(said_with("/bodies/2/position_m", "[0, NaN, 0]"),
               Catch::Contains("bodies[2].position_m[1] NaN: must be a finite number"));
}

TEST_CASE(
    "every option with a number refuses NaN, infinities, and zero and negative ones where they make no sense") {
    // Options that may be zero.
    const std::set<std::string_view> may_be_zero{"seconds", "tolerance", "beta",        "distance-beta",
                                                 "slop",    "friction",  "restitution", "margin"};
    for (const SimulationOption& option : simulation_options()) {
        INFO(option.name);
        for (const char* const text : {"NaN", "nan", "-nan", "inf", "-inf", "Infinity", "1e999", "-1e999", "", " ",
                                       "-1", "-1e-9", "0x10", "1,5"}) {
            INFO(text);
            CHECK(refuses(option, text));
        }
        CHECK(refuses(option, "0") == !may_be_zero.contains(option.name));
    }
    for (const FrameOption& option : frame_options()) {
        FrameChoices choices;
        for (const char* const text : {"NaN", "inf", "-inf", "1e999", "-1", "", "orbit:nan", "orbit:inf", "1x1"}) {
            if (option.name == "overlay" || option.name == "camera")
                continue;  // words and files have their own tests
            INFO(option.name << " " << text);
            CHECK(!option.set(choices, text));
        }
        const std::set<std::string_view> zero{"at", "ghosts", "shutter", "overlay", "camera"};
        if (!zero.contains(option.name)) CHECK(!option.set(choices, "0"));
    }
}

TEST_CASE("every parameter of every scene refuses what is no finite number in its range") {
    for (const SceneEntry& scene : catalogue()) {
        for (const Parameter& parameter : scene.parameters) {
            ParameterValues values(scene.parameters);
            INFO(scene.name << " " << parameter.name);
            for (const char* const text : {"NaN", "nan", "inf", "-inf", "1e999", "-1e999", "", "1e300", "-1e300"}) {
                CHECK(!values.set(parameter, text));
            }
            CHECK(!values.given(parameter.name));
            if (parameter.whole) CHECK(!values.set(parameter, "1.5"));
        }
    }
}

TEST_CASE("the program refuses bad input with status 2 and one line, and writes nothing") {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"stack --restitution 1.0001", "--restitution 1.0001: must be a number from 0 to 1"},
        {"stack --friction nan", "--friction nan: must be a number from 0 to 100"},
        {"stack --dt 0", "--dt 0: must be a time from 1e-6 to 1 s"},
        {"stack --dt -1/60", "--dt -1/60: must be a time"},
        {"stack --seconds inf", "--seconds inf: must be a number of seconds"},
        {"stack --substeps 0", "--substeps 0: must be a whole number from 1 to 10000, or auto"},
        {"chain --end-mass 0", "--end-mass 0: must be a number from"},
        {"chain --end-mass nan", "--end-mass nan: must be a number from"},
        {"bad.json", "bad.json: bodies[0].mass_kg NaN: must be a finite number"},
        {"pair.json",
         "pair.json: distance_constraints[0].b.body \"world\": must be a movable body, as a is static"},
        {"fast.json",
         "fast.json: size, mass and velocity of ball together: must be less extreme, as its linear momentum is "
         "beyond what numbers can be (1e308)"},
    };
    const Folder folder;
    const auto scene = [](const std::string& ball, const std::string& rest = "") {
        return R"({"version": 1, "bodies": [{"name": "ball", "shape": "sphere", "radius_m": 1, )" + ball + "}]" +
               rest + "}";
    };
    folder.write("bad.json", scene("\"mass_kg\": NaN"));
    folder.write("pair.json",
                 scene("\"static\": true",
                       R"(, "distance_constraints": [{"a": {"body": "ball"}, "b": {"body": "world"}}])"));
    folder.write("fast.json", scene("\"mass_kg\": 1e10, \"velocity_m_per_s\": [1e300, 0, 0]"));
    for (const auto& [arguments, message] : wrong) {
        const tests::Ended ended = tests::shell(
            folder, "pushfactor run " + arguments + " --csv steps.csv --summary s.json --save-state x.json");
        INFO(ended.err);
        CHECK(ended.status == 2);
        CHECK_THAT(ended.err, Catch::Contains(message));
        CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
        CHECK(ended.out.empty());
    }
    CHECK(folder.files() == std::vector<std::string>{"bad.json", "fast.json", "pair.json"});
}
