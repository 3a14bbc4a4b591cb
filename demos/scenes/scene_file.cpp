#include "demos/scenes/scene_file.h"

#include "demos/scenes/camera_file.h"
#include "demos/scenes/motions/motion_file.h"
#include "demos/scenes/reading/bodies.h"
#include "demos/scenes/reading/connections.h"
#include "demos/scenes/reading/fields.h"
#include "demos/scenes/reading/polyhedra.h"
#include "demos/scenes/scene_file_words.h"
#include "demos/scenes/state_file.h"
#include "demos/text/errors.h"
#include "demos/text/json_file.h"
#include "demos/text/json_reader.h"
#include "demos/text/palette.h"
#include "demos/text/utf8.h"

#include <map>
#include <set>

namespace pushfactor::demos {

namespace {

using engine::Vector3;

const Keys scene_keys{"version", "name",    "gravity_m_per_s2", "bodies",      "distance_constraints",
                      "joints",  "forces",  "contacts",         "no_contacts", "material_pairs",
                      "state",   "options", "camera",           "colours"};
const Keys material_pair_keys{"a", "b", "friction", "restitution"};

// Of a scene that does not say its own.
std::string name_of_file(const std::filesystem::path& file) {
    std::error_code ignored;
    const std::string stem = std::filesystem::is_regular_file(file, ignored) ? file.stem().string() : "";
    return stem.empty() ? "scene" : utf8(stem);
}

std::pair<std::string, std::string> read_no_contact(const JsonReader& json, const BodyNames& names) {
    const std::vector<JsonReader> ends = json.elements();
    if (ends.size() != 2) json.refuse("two names of bodies");
    std::pair<std::string, std::string> pair{read_body_name(ends[0], names, false),
                                             read_body_name(ends[1], names, false)};
    if (pair.first == pair.second) ends[1].refuse("another body than the first");
    return pair;
}

void read_material_pairs(const JsonReader& json, SceneDescription& scene) {
    std::set<std::string> known;
    for (const BodyDescription& body : scene.bodies) known.insert(body.material);
    const auto material = [&](const JsonReader& name) {
        if (!known.contains(read_name(name))) name.refuse("the material of a body");
        return name.string();
    };
    std::set<std::pair<std::string, std::string>> pairs;
    for (const JsonReader& entry : json.elements()) {
        entry.require_object(material_pair_keys);
        MaterialPairDescription pair{.a = material(entry.at("a")), .b = material(entry.at("b"))};
        if (!pairs.insert(std::minmax(pair.a, pair.b)).second) entry.refuse("a pair that is listed once");
        if (entry.has("friction")) pair.friction = entry.at("friction").number(0.0, 100.0);
        if (entry.has("restitution")) pair.restitution = entry.at("restitution").number(0.0, 1.0);
        if (!pair.friction && !pair.restitution) entry.refuse("given friction or restitution, or both");
        scene.materials.push_back(pair);
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
    scene.name = json.has("name") ? json.at("name").string() : name_of_file(file);
    // It becomes the name of a folder of frames, so it must not lead elsewhere.
    const bool plain =
        !scene.name.empty() && scene.name.front() != '.' && scene.name.find('/') == std::string::npos;
    if (json.has("name") && !plain) json.at("name").refuse("a name without slashes that does not begin with a dot");
    if (json.at("version").number(0, 1e9) != scene_file_version)
        json.at("version").refuse(std::to_string(scene_file_version));
    scene.gravity = json.has("gravity_m_per_s2") ? json.at("gravity_m_per_s2").vector() : Vector3::Zero();

    BodyNames names;
    Polyhedra polyhedra{.folder = file.parent_path()};
    read_bodies(json.at("bodies"), scene, names, polyhedra);
    if (json.has("distance_constraints")) {
        for (const JsonReader& entry : json.at("distance_constraints").elements()) {
            scene.distances.push_back(to_body_frames(read_distance(entry, names), polyhedra));
        }
    }
    if (json.has("joints")) {
        for (const JsonReader& entry : json.at("joints").elements())
            scene.joints.push_back(to_body_frames(read_joint(entry, names), polyhedra));
    }
    if (json.has("forces")) {
        for (const JsonReader& entry : json.at("forces").elements())
            scene.forces.push_back(to_body_frame(read_force(entry, names), entry.has("point_m"), polyhedra));
    }
    scene.contacts = json.has("contacts") && json.at("contacts").boolean();
    if (json.has("no_contacts")) {
        for (const JsonReader& entry : json.at("no_contacts").elements())
            scene.no_contacts.push_back(read_no_contact(entry, names));
    }
    if (json.has("material_pairs")) read_material_pairs(json.at("material_pairs"), scene);
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
        all.merge(connection_keys());
        all.insert({{"scene", scene_keys},
                    {"body", body_keys()},
                    {"material_pair", material_pair_keys},
                    {"camera", {camera_keys().begin(), camera_keys().end()}}});
        return all;
    }();
    return keys;
}

SceneDescription read_scene_file(const std::filesystem::path& file) {
    const Json json = read_json_file(file, file.string());
    return read_scene(JsonReader(json, file.string()), file);
}

}  // namespace pushfactor::demos
