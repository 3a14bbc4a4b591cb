#include "demos/scenes/scene_file.h"

#include "demos/scenes/camera_file.h"
#include "demos/scenes/motion_file.h"
#include "demos/scenes/scene_file_words.h"
#include "demos/scenes/state_file.h"
#include "demos/text/errors.h"
#include "demos/text/json_file.h"
#include "demos/text/json_reader.h"
#include "demos/text/palette.h"

#include <fmt/format.h>

#include <map>

namespace pushfactor::demos {

namespace {

using engine::Vector3;

constexpr std::size_t most_bodies = 100000;

using Keys = std::vector<std::string>;
const Keys scene_keys{
    "version", "name",    "gravity_m_per_s2", "bodies", "distance_constraints", "forces", "contacts",
    "state",   "options", "camera",           "colours"};
const Keys body_keys{"name",
                     "shape",
                     "size_m",
                     "radius_m",
                     "mass_kg",
                     "static",
                     "motion",
                     "position_m",
                     "orientation_wxyz",
                     "velocity_m_per_s",
                     "angular_velocity_rad_per_s",
                     "linear_momentum_kg_m_per_s",
                     "angular_momentum_kg_m2_per_s",
                     "friction",
                     "restitution",
                     "surface_velocity_m_per_s",
                     "surface_from_s"};
const Keys distance_keys{"a", "b", "length_m", "acts", "max_force_n"};
const Keys end_keys{"body", "point_m"};
const Keys force_keys{"body", "force_n", "from_s", "until_s"};

double read_length(const JsonReader& json) {
    return json.number(engine::least_length, engine::greatest_length);
}

decltype(BodyDescription::shape) read_shape(const JsonReader& body) {
    const JsonReader shape = body.at("shape");
    const std::string name = shape.string();
    if (name == "plane") return PlaneShape{};
    if (name == "sphere") return SphereShape{read_length(body.at("radius_m"))};
    if (name != "box") shape.refuse("one of box, sphere, plane");
    const JsonReader size = body.at("size_m");
    const std::vector<JsonReader> edges = size.elements();
    if (edges.size() != 3) size.refuse("three numbers [x, y, z]");
    return BoxShape{{read_length(edges[0]), read_length(edges[1]), read_length(edges[2])}};
}

void refuse_if_given(const JsonReader& json, std::initializer_list<const char*> keys, const std::string& allowed) {
    for (const char* key : keys) {
        if (json.has(key)) json.at(key).refuse(allowed);
    }
}

// What would be read by nobody was meant for something.
void refuse_foreign_keys(const JsonReader& json, const BodyDescription& body, bool fixed) {
    const bool plane = std::holds_alternative<PlaneShape>(body.shape);
    std::visit(
        engine::Overloaded{
            [&](const BoxShape&) { refuse_if_given(json, {"radius_m"}, "left out: a box has size_m"); },
            [&](const SphereShape&) { refuse_if_given(json, {"size_m"}, "left out: a sphere has radius_m"); },
            [&](const PlaneShape&) {
                refuse_if_given(json, {"size_m", "radius_m"}, "left out: a plane has no size");
            }},
        body.shape);
    if (plane) refuse_if_given(json, {"mass_kg"}, "left out: a plane is static");
    if (plane || fixed) {
        refuse_if_given(json,
                        {"mass_kg", "velocity_m_per_s", "angular_velocity_rad_per_s", "linear_momentum_kg_m_per_s",
                         "angular_momentum_kg_m2_per_s"},
                        "left out of a static body");
    }
    if (json.has("linear_momentum_kg_m_per_s")) {
        refuse_if_given(json, {"velocity_m_per_s"}, "left out where the momentum is given");
    }
    if (json.has("angular_momentum_kg_m2_per_s")) {
        refuse_if_given(json, {"angular_velocity_rad_per_s"}, "left out where the momentum is given");
    }
}

BodyDescription read_body(const JsonReader& json) {
    json.require_object(body_keys);
    BodyDescription body{.name = json.at("name").string(), .shape = read_shape(json)};
    const bool fixed = json.has("static") && json.at("static").boolean();
    refuse_foreign_keys(json, body, fixed);
    if (!fixed && !std::holds_alternative<PlaneShape>(body.shape)) {
        body.mass = json.at("mass_kg").number(engine::least_mass, engine::greatest_mass);
    }

    if (json.has("motion")) {
        if (body.mass)
            json.at("motion").refuse("left out of a body with a mass; \"static\": true makes it one without");
        body.motion = read_motion(json.at("motion"));
    }

    const auto vector = [&json](const char* key, Vector3& into) {
        if (json.has(key)) into = json.at(key).vector();
    };
    vector("position_m", body.position);
    if (json.has("orientation_wxyz")) body.orientation = json.at("orientation_wxyz").rotation();
    vector("velocity_m_per_s", body.velocity);
    vector("angular_velocity_rad_per_s", body.angular_velocity);
    vector("surface_velocity_m_per_s", body.surface_velocity);
    if (json.has("surface_from_s")) body.surface_from = json.at("surface_from_s").number(0.0, 1e9);
    if (json.has("linear_momentum_kg_m_per_s"))
        body.linear_momentum = json.at("linear_momentum_kg_m_per_s").vector();
    if (json.has("angular_momentum_kg_m2_per_s"))
        body.angular_momentum = json.at("angular_momentum_kg_m2_per_s").vector();
    if (json.has("friction")) body.friction = json.at("friction").number(0.0, 100.0);
    if (json.has("restitution")) body.restitution = json.at("restitution").number(0.0, 1.0);
    return body;
}

// All bodies so far by name, and whether they are static; constraints and forces look theirs up.
using Names = std::map<std::string, bool, std::less<>>;

std::string read_body_name(const JsonReader& json, const Names& names, bool or_world) {
    std::string name = json.string();
    if (!names.contains(name) && !(or_world && name == "world")) {
        json.refuse(or_world ? "the name of a body, or world" : "the name of a body");
    }
    return name;
}

DistanceDescription::End read_end(const JsonReader& json, const Names& names) {
    json.require_object(end_keys);
    DistanceDescription::End end{.body = read_body_name(json.at("body"), names, true)};
    if (json.has("point_m")) end.point = json.at("point_m").vector();
    return end;
}

DistanceDescription read_distance(const JsonReader& json, const Names& names) {
    json.require_object(distance_keys);
    DistanceDescription distance{.a = read_end(json.at("a"), names), .b = read_end(json.at("b"), names)};
    if (distance.a.body == distance.b.body) json.at("b").at("body").refuse("another body than a");
    const auto is_static = [&](const std::string& name) { return name == "world" || names.at(name); };
    if (is_static(distance.a.body) && is_static(distance.b.body)) {
        json.at("b").at("body").refuse("a movable body, as a is static");
    }
    if (json.has("length_m")) distance.length = json.at("length_m").not_negative();
    if (json.has("max_force_n")) distance.max_force = json.at("max_force_n").positive();
    if (json.has("acts")) {
        const std::string acts = json.at("acts").string();
        const auto found = std::find_if(act_names.begin(), act_names.end(),
                                        [&](const auto& entry) { return entry.first == acts; });
        if (found == act_names.end()) json.at("acts").refuse("one of both, pulls, pushes");
        distance.acts = found->second;
    }
    if (distance.length == 0.0 && (distance.acts != engine::Distance::Acts::both || distance.max_force)) {
        json.at("length_m").refuse("above 0, or it is a ball joint, which acts both ways and without max_force_n");
    }
    return distance;
}

ForceDescription read_force(const JsonReader& json, const Names& names) {
    json.require_object(force_keys);
    ForceDescription force{.body = read_body_name(json.at("body"), names, false),
                           .force = json.at("force_n").vector()};
    if (json.has("from_s")) force.from = json.at("from_s").number(0.0, 1e9);
    if (json.has("until_s")) force.until = json.at("until_s").number(force.from, 1e9);
    return force;
}

void read_bodies(const JsonReader& json, SceneDescription& scene, Names& names) {
    const std::vector<JsonReader> bodies = json.elements();
    if (bodies.size() > most_bodies) json.refuse(fmt::format("at most {} bodies", most_bodies));
    for (const JsonReader& body : bodies) {
        scene.bodies.push_back(read_body(body));
        const std::string& name = scene.bodies.back().name;
        if (name.empty() || name == "world") body.at("name").refuse("a name other than world");
        if (!names.emplace(name, !scene.bodies.back().mass).second)
            body.at("name").refuse("a name that no other body has");
    }
}

void read_options(const JsonReader& json, SceneDescription& scene) {
    json.require_object();
    for (const auto& [name, value] : json.json().items()) {
        if (!value.is_string() && !value.is_number()) json.at(name).refuse("a string or a number");
        scene.options[name] = value.is_string() ? value.get<std::string>() : value.dump();
    }
}

void read_colours(const JsonReader& json, SceneDescription& scene) {
    std::map<std::string, BodyDescription*> bodies;
    for (BodyDescription& body : scene.bodies) bodies[body.name] = &body;
    json.require_object();
    for (const auto& [name, value] : json.json().items()) {
        const JsonReader colour = json.at(name);
        if (!bodies.contains(name)) colour.refuse("given to a body of the scene");
        if (!find_colour(colour.string())) colour.refuse("one of " + colour_names());
        bodies[name]->colour = colour.string();
    }
}

SceneDescription read_scene(const JsonReader& json, const std::filesystem::path& file) {
    json.require_object(scene_keys);
    SceneDescription scene;
    scene.name = json.has("name") ? json.at("name").string() : file.stem().string();
    // It becomes the name of a folder of frames, so it may not lead out of it.
    const bool plain =
        !scene.name.empty() && scene.name.front() != '.' && scene.name.find('/') == std::string::npos;
    if (json.has("name") && !plain) json.at("name").refuse("a name without slashes that does not begin with a dot");
    if (json.at("version").number(0, 1e9) != scene_file_version)
        json.at("version").refuse(std::to_string(scene_file_version));
    scene.gravity = json.has("gravity_m_per_s2") ? json.at("gravity_m_per_s2").vector() : Vector3::Zero();

    Names names;
    read_bodies(json.at("bodies"), scene, names);
    if (json.has("distance_constraints")) {
        for (const JsonReader& entry : json.at("distance_constraints").elements()) {
            scene.distances.push_back(read_distance(entry, names));
        }
    }
    if (json.has("forces")) {
        for (const JsonReader& entry : json.at("forces").elements())
            scene.forces.push_back(read_force(entry, names));
    }
    scene.contacts = json.has("contacts") && json.at("contacts").boolean();
    if (json.has("state")) scene.state = std::make_shared<RunState>(read_state(json.at("state"), scene));
    if (json.has("options")) read_options(json.at("options"), scene);
    scene.has_camera = json.has("camera");
    if (scene.has_camera) scene.view = read_camera(json.at("camera"));
    if (json.has("colours")) read_colours(json.at("colours"), scene);
    return scene;
}

}  // namespace

const std::map<std::string, std::vector<std::string>>& scene_file_keys() {
    static const std::map<std::string, std::vector<std::string>> keys = [] {
        std::map<std::string, std::vector<std::string>> all = state_file_keys();
        all.insert(motion_file_keys().begin(), motion_file_keys().end());
        all.insert({
            {"scene", scene_keys},
            {"body", body_keys},
            {"distance_constraint", distance_keys},
            {"end", end_keys},
            {"force", force_keys},
            {"camera", {camera_keys().begin(), camera_keys().end()}},
        });
        return all;
    }();
    return keys;
}

SceneDescription read_scene_file(const std::filesystem::path& file) {
    const Json json = read_json_file(file, file.string());
    return read_scene(JsonReader(json, file.string()), file);
}

}  // namespace pushfactor::demos
