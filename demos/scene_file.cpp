#include "demos/scene_file.h"

#include "demos/camera_file.h"
#include "demos/errors.h"
#include "demos/json_reader.h"
#include "demos/palette.h"
#include "demos/simulation_options.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <map>
#include <set>

namespace pushfactor::demos {

namespace {

using engine::Distance;
using engine::Vector3;

constexpr int format_version = 1;
constexpr std::size_t most_bodies = 100000;
constexpr std::uintmax_t most_bytes = 100'000'000;

using Keys = std::vector<std::string>;
const Keys scene_keys{"version", "name",     "gravity_m_per_s2", "bodies", "distance_constraints",
                      "forces",  "contacts", "options",          "camera", "colours"};
const Keys body_keys{"name",
                     "shape",
                     "size_m",
                     "radius_m",
                     "mass_kg",
                     "static",
                     "position_m",
                     "orientation_wxyz",
                     "velocity_m_per_s",
                     "angular_velocity_rad_per_s",
                     "linear_momentum_kg_m_per_s",
                     "angular_momentum_kg_m2_per_s",
                     "friction",
                     "restitution",
                     "surface_velocity_m_per_s"};
const Keys distance_keys{"a", "b", "length_m", "acts", "max_force_n"};
const Keys end_keys{"body", "point_m"};
const Keys force_keys{"body", "force_n", "from_s", "until_s"};

constexpr std::array<std::pair<std::string_view, Distance::Acts>, 3> act_names{
    {{"both", Distance::Acts::both}, {"pulls", Distance::Acts::pulls}, {"pushes", Distance::Acts::pushes}}};

decltype(BodyDescription::shape) read_shape(const JsonReader& body) {
    const JsonReader shape = body.at("shape");
    const std::string name = shape.string();
    if (name == "plane") return PlaneShape{};
    if (name == "sphere") return SphereShape{body.at("radius_m").positive()};
    if (name != "box") shape.refuse("one of box, sphere, plane");
    const JsonReader size = body.at("size_m");
    const Vector3 edges = size.vector();
    if (!(edges.array() > 0.0).all()) size.refuse("three numbers above 0");
    return BoxShape{edges};
}

BodyDescription read_body(const JsonReader& json) {
    json.require_object(body_keys);
    BodyDescription body{.name = json.at("name").string(), .shape = read_shape(json)};
    const bool fixed = json.has("static") && json.at("static").boolean();
    const bool plane = std::holds_alternative<PlaneShape>(body.shape);
    if (plane && json.has("mass_kg")) json.at("mass_kg").refuse("left out: a plane is static");
    if (fixed && json.has("mass_kg")) json.at("mass_kg").refuse("left out of a static body");
    if (!fixed && !plane) body.mass = json.at("mass_kg").positive();

    const auto vector = [&json](const char* key, Vector3& into) {
        if (json.has(key)) into = json.at(key).vector();
    };
    vector("position_m", body.position);
    if (json.has("orientation_wxyz")) body.orientation = json.at("orientation_wxyz").rotation();
    vector("velocity_m_per_s", body.velocity);
    vector("angular_velocity_rad_per_s", body.angular_velocity);
    vector("surface_velocity_m_per_s", body.surface_velocity);
    if (json.has("linear_momentum_kg_m_per_s"))
        body.linear_momentum = json.at("linear_momentum_kg_m_per_s").vector();
    if (json.has("angular_momentum_kg_m2_per_s"))
        body.angular_momentum = json.at("angular_momentum_kg_m2_per_s").vector();
    if (json.has("friction")) body.friction = json.at("friction").number(0.0, 100.0);
    if (json.has("restitution")) body.restitution = json.at("restitution").number(0.0, 1.0);
    return body;
}

// The names of all bodies so far; constraints and forces look theirs up.
using Names = std::set<std::string, std::less<>>;

std::string read_body_name(const JsonReader& json, const Names& names, bool or_world) {
    const std::string name = json.string();
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
    if (json.has("length_m")) distance.length = json.at("length_m").number(0.0, 1e9);
    if (json.has("max_force_n")) distance.max_force = json.at("max_force_n").positive();
    if (json.has("acts")) {
        const std::string acts = json.at("acts").string();
        const auto found = std::find_if(act_names.begin(), act_names.end(),
                                        [&](const auto& entry) { return entry.first == acts; });
        if (found == act_names.end()) json.at("acts").refuse("one of both, pulls, pushes");
        distance.acts = found->second;
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
        if (!names.insert(name).second) body.at("name").refuse("a name that no other body has");
    }
}

void read_options(const JsonReader& json, SceneDescription& scene) {
    json.require_object(simulation_option_names());
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
    if (json.at("version").number(0, 1e9) != format_version)
        json.at("version").refuse(std::to_string(format_version));
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
    if (json.has("options")) read_options(json.at("options"), scene);
    if (json.has("camera")) scene.view = read_camera(json.at("camera"));
    if (json.has("colours")) read_colours(json.at("colours"), scene);
    return scene;
}

Json to_json(const Vector3& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Json to_json(const BodyDescription& body) {
    Json json{{"name", body.name}};
    if (const auto* box = std::get_if<BoxShape>(&body.shape)) {
        json["shape"] = "box";
        json["size_m"] = to_json(box->size);
    } else if (const auto* sphere = std::get_if<SphereShape>(&body.shape)) {
        json["shape"] = "sphere";
        json["radius_m"] = sphere->radius;
    } else {
        json["shape"] = "plane";
    }
    if (body.mass) {
        json["mass_kg"] = *body.mass;
    } else if (!std::holds_alternative<PlaneShape>(body.shape)) {
        json["static"] = true;
    }
    json["position_m"] = to_json(body.position);
    const engine::Quaternion& q = body.orientation;
    json["orientation_wxyz"] = Json::array({q.w(), q.x(), q.y(), q.z()});
    if (!body.velocity.isZero(0.0)) json["velocity_m_per_s"] = to_json(body.velocity);
    if (!body.angular_velocity.isZero(0.0)) json["angular_velocity_rad_per_s"] = to_json(body.angular_velocity);
    if (body.linear_momentum) json["linear_momentum_kg_m_per_s"] = to_json(*body.linear_momentum);
    if (body.angular_momentum) json["angular_momentum_kg_m2_per_s"] = to_json(*body.angular_momentum);
    json["friction"] = body.friction;
    if (body.restitution != 0.0) json["restitution"] = body.restitution;
    if (!body.surface_velocity.isZero(0.0)) json["surface_velocity_m_per_s"] = to_json(body.surface_velocity);
    return json;
}

Json to_json(const DistanceDescription::End& end) {
    return {{"body", end.body}, {"point_m", to_json(end.point)}};
}

Json to_json(const DistanceDescription& distance) {
    Json json{{"a", to_json(distance.a)}, {"b", to_json(distance.b)}};
    if (distance.length) json["length_m"] = *distance.length;
    for (const auto& [name, acts] : act_names) {
        if (acts == distance.acts && acts != Distance::Acts::both) json["acts"] = name;
    }
    if (distance.max_force) json["max_force_n"] = *distance.max_force;
    return json;
}

Json to_json(const ForceDescription& force) {
    Json json{{"body", force.body}, {"force_n", to_json(force.force)}, {"from_s", force.from}};
    if (force.until) json["until_s"] = *force.until;
    return json;
}

template <typename Described>
void put_list(Json& json, const char* key, const std::vector<Described>& list) {
    if (list.empty()) return;
    json[key] = Json::array();
    for (const Described& described : list) json[key].push_back(to_json(described));
}

}  // namespace

const std::map<std::string, std::vector<std::string>>& scene_file_keys() {
    static const std::map<std::string, std::vector<std::string>> keys{
        {"scene", scene_keys}, {"body", body_keys},   {"distance_constraint", distance_keys},
        {"end", end_keys},     {"force", force_keys}, {"camera", {camera_keys().begin(), camera_keys().end()}},
    };
    return keys;
}

SceneDescription read_scene_file(const std::filesystem::path& file) {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(file, error);
    std::ifstream stream(file, std::ios::binary);
    if (error || !stream) throw UsageError(fmt::format("scene file {}: cannot be read", file.string()));
    if (bytes > most_bytes) {
        throw UsageError(
            fmt::format("{}: must be at most {} bytes long, not {}", file.string(), most_bytes, bytes));
    }
    Json json;
    try {
        json = Json::parse(stream);
    } catch (const Json::exception& problem) {
        const std::string what = problem.what();
        throw UsageError(fmt::format("{}: is no JSON: {}", file.string(), what.substr(what.find("] ") + 2)));
    }
    return read_scene(JsonReader(json, file.string()), file);
}

std::string scene_file_text(const SceneDescription& scene) {
    Json json;
    json["version"] = format_version;
    json["name"] = scene.name;
    if (!scene.gravity.isZero(0.0)) json["gravity_m_per_s2"] = to_json(scene.gravity);
    json["bodies"] = Json::array();
    put_list(json, "bodies", scene.bodies);
    put_list(json, "distance_constraints", scene.distances);
    put_list(json, "forces", scene.forces);
    if (scene.contacts) json["contacts"] = true;
    for (const auto& [name, text] : scene.options) json["options"][name] = json_of(text);
    json["camera"] = camera_json(scene.view);
    for (const BodyDescription& body : scene.bodies) {
        if (body.colour) json["colours"][body.name] = *body.colour;
    }
    return json.dump(2) + "\n";
}

}  // namespace pushfactor::demos
