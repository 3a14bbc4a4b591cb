#include "demos/scenes/scene_file.h"

#include "demos/base/text/json_reader.h"
#include "demos/base/text/palette.h"
#include "demos/base/text/suggest.h"
#include "demos/base/text/utf8.h"
#include "demos/scenes/reading/parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

namespace pushfactor::demos {

void describe(Fields& fields, View& view) {
    const auto place = [](const JsonReader& json) {
        const engine::Vector3 point = json.vector();
        if (point.cwiseAbs().maxCoeff() > 1e9) json.refuse("three numbers from -1e9 to 1e9");
        return point;
    };
    fields.must("eye_m", view.eye, place);
    fields.must("target_m", view.target, place);
    fields.may("field_of_view_deg", view.field_of_view, between(1.0, 120.0),
               view.field_of_view != View{}.field_of_view);
    fields.if_any("floor_m", view.floor, between(-1e9, 1e9));
}

void describe(Fields& fields, MaterialPairDescription& pair) {
    fields.must("a", pair.a, read_name);
    fields.must("b", pair.b, read_name);
    fields.if_any("friction", pair.friction, between(0.0, 100.0));
    fields.if_any("restitution", pair.restitution, between(0.0, 1.0));
}

void describe(Fields& fields, Standing& standing) {
    const auto heights = [](const JsonReader& json) { return read_each(json, between(-1e9, 1e9)); };
    fields.must("side_m", standing.side, between(1e-50, 1e50));
    fields.must("rest_heights_m", standing.rest_heights, heights);
}

namespace {

using NoContact = std::pair<std::string, std::string>;

constexpr int scene_file_version = 1;

View read_camera(const JsonReader& json) {
    const auto view = read_object<View>(json);
    if (view.eye == view.target) json.at("target_m").refuse("another point than eye_m");
    return view;
}

// Of a scene that does not say its own.
std::string name_of_file(const std::filesystem::path& file) {
    std::error_code ignored;
    const std::string stem = std::filesystem::is_regular_file(file, ignored) ? file.stem().string() : "";
    return stem.empty() ? "scene" : utf8(stem);
}

NoContact read_no_contact(const JsonReader& json, const BodyNames& names) {
    const std::vector<JsonReader> ends = json.elements();
    if (ends.size() != 2) json.refuse("two names of bodies");
    NoContact pair{read_body_name(ends[0], names, false), read_body_name(ends[1], names, false)};
    if (pair.first == pair.second) ends[1].refuse("another body than the first");
    return pair;
}

std::vector<MaterialPairDescription> read_material_pairs(const JsonReader& json, const SceneDescription& scene) {
    std::set<std::string> known;
    for (const BodyDescription& body : scene.bodies) known.insert(body.material);
    std::set<std::pair<std::string, std::string>> pairs;
    std::vector<MaterialPairDescription> list;
    for (const JsonReader& entry : json.elements()) {
        const auto pair = read_object<MaterialPairDescription>(entry);
        for (const char* const key : {"a", "b"}) {
            if (!known.contains(entry.at(key).string())) entry.at(key).refuse("the material of a body");
        }
        if (!pairs.insert(std::minmax(pair.a, pair.b)).second) entry.refuse("a pair that is listed once");
        if (!pair.friction && !pair.restitution) entry.refuse("given friction or restitution, or both");
        list.push_back(pair);
    }
    return list;
}

Standing read_standing(const JsonReader& json, const SceneDescription& scene) {
    auto standing = read_object<Standing>(json);
    const auto movable = std::count_if(scene.bodies.begin(), scene.bodies.end(),
                                       [](const auto& body) { return body.mass.has_value(); });
    if (std::ssize(standing.rest_heights) != movable) {
        json.at("rest_heights_m").refuse(fmt::format("one height for each of the {} bodies with a mass", movable));
    }
    return standing;
}

void read_options(const JsonReader& json, SceneDescription& scene) {
    json.require_object();
    for (const auto& [name, value] : json.json().items()) {
        if (!value.is_string() && !value.is_number()) json.at(name).refuse("a string or a number");
        scene.options[name] = text_of(value);
    }
}

void read_colours(const JsonReader& json, SceneDescription& scene) {
    std::map<std::string, BodyDescription*> bodies;
    for (BodyDescription& body : scene.bodies) bodies[body.name] = &body;
    json.require_object();
    for (const auto& [name, value] : json.json().items()) {
        const JsonReader colour = json.at(name);
        if (!bodies.contains(name)) colour.refuse("given to a body of the scene");
        if (!find_colour(colour.string()))
            colour.refuse(fmt::format("one of {}", fmt::join(names_of(palette), ", ")));
        bodies[name]->colour = colour.string();
    }
}

// It becomes the name of a folder of frames, so it must not lead elsewhere.
std::string read_scene_name(const JsonReader& json) {
    const std::string name = json.string();
    const bool plain = !name.empty() && name.front() != '.' && name.find('/') == std::string::npos;
    if (!plain) json.refuse("a name without slashes that does not begin with a dot");
    return name;
}

int read_version(const JsonReader& json) {
    if (json.number(0, 1e9) != scene_file_version) json.refuse(std::to_string(scene_file_version));
    return scene_file_version;
}

// All but state, options, camera and colours.
void describe(Fields& fields, SceneDescription& scene, const std::filesystem::path& folder) {
    BodyNames names;
    Polyhedra polyhedra{.folder = folder};
    // The entries of a list; `read` gets what has been read of the scene so far.
    const auto each = [&](const auto& read) {
        return [&](const JsonReader& json) {
            return read_each(json, [&](const JsonReader& entry) { return read(entry, names, polyhedra); });
        };
    };
    int version = scene_file_version;
    fields.must("version", version, read_version);
    fields.may("name", scene.name, read_scene_name);
    fields.if_any("gravity_m_per_s2", scene.gravity, &JsonReader::vector);
    fields.must("bodies", scene.bodies,
                [&](const JsonReader& json) { return read_bodies(json, names, polyhedra); });
    fields.if_any("distance_constraints", scene.distances, each(read_distance));
    fields.if_any("joints", scene.joints, each(read_joint));
    fields.if_any("forces", scene.forces, each(read_force));
    fields.if_any("contacts", scene.contacts, &JsonReader::boolean);
    fields.if_any("no_contacts", scene.no_contacts,
                  each([](const auto& json, const auto& of, const auto&) { return read_no_contact(json, of); }));
    fields.if_any("material_pairs", scene.materials,
                  [&](const JsonReader& json) { return read_material_pairs(json, scene); });
    fields.if_any("standing", scene.standing, [&](const JsonReader& json) { return read_standing(json, scene); });
}

const Keys& scene_keys() {
    static const Keys keys = [] {
        Keys all;
        Fields fields(all);
        SceneDescription scene;
        describe(fields, scene, "");
        return joined({all, {"$schema", "state", "options", "camera", "colours"}});
    }();
    return keys;
}

}  // namespace

const std::map<std::string, std::vector<std::string>>& scene_file_keys() {
    static const KeysByObject keys = [] {
        KeysByObject all{{"scene", scene_keys()},
                         {"body", body_keys()},
                         {"material_pair", keys_of<MaterialPairDescription>()},
                         {"standing", keys_of<Standing>()},
                         {"camera", keys_of<View>()}};
        for (KeysByObject more : {state_keys(), motion_file_keys(), connection_keys()}) all.merge(more);
        return all;
    }();
    return keys;
}

SceneDescription read_scene_file(const std::filesystem::path& file) {
    const Json document = read_json_file(file, file.string());
    const JsonReader json(document, file.string());
    json.require_object(scene_keys());
    if (json.has("$schema")) json.at("$schema").string();  // for editors
    SceneDescription scene;
    scene.name = name_of_file(file);
    scene.gravity.setZero();
    Fields fields(json);
    describe(fields, scene, file.parent_path());
    if (json.has("state")) scene.state = std::make_shared<RunState>(read_state(json.at("state"), scene));
    if (json.has("options")) read_options(json.at("options"), scene);
    scene.has_camera = json.has("camera");
    if (scene.has_camera) scene.view = read_camera(json.at("camera"));
    if (json.has("colours")) read_colours(json.at("colours"), scene);
    return scene;
}

View read_camera_file(const std::filesystem::path& file) {
    const Json json = read_json_file(file, "--camera " + file.string());
    return read_camera(JsonReader(json, file.string()));
}

std::string scene_file_text(const SceneDescription& scene) {
    Json json;
    Fields fields(json);
    SceneDescription written = scene;
    describe(fields, written, "");
    if (scene.state) json["state"] = state_json(*scene.state, scene);
    for (const auto& [name, text] : scene.options) json["options"][name] = json_of(text);
    if (scene.has_camera) json["camera"] = to_json(scene.view);
    for (const BodyDescription& body : scene.bodies) {
        if (body.colour) json["colours"][body.name] = *body.colour;
    }
    return json_text(json);
}

}  // namespace pushfactor::demos
