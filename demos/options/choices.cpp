#include "demos/options/choices.h"

#include "demos/base/platform/messages.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/json_reader.h"
#include "demos/base/text/numbers.h"
#include "demos/base/text/suggest.h"
#include "demos/base/text/text_hash.h"
#include "demos/options/simulation_options.h"
#include "demos/scenes/motions/measured_motion.h"
#include "demos/scenes/scene_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos {

namespace {

[[noreturn]] void refuse(const GivenOptions::Given& given, std::string_view allowed) {
    throw UsageError("{} {}: must be {}", given.field, given.text, allowed);
}

Settings understand_settings(const GivenOptions& given) {
    std::string preset = "default";
    if (const auto* chosen = given.find("preset")) {
        require_known(chosen->field, chosen->text, names_of(presets()));
        preset = chosen->text;
    }
    Settings settings = preset_settings(preset);
    for (const SimulationOption& option : simulation_options()) {
        const auto* chosen = given.find(option.name);
        if (chosen && !option.set(settings, chosen->text)) refuse(*chosen, option.allowed);
    }
    return settings;
}

// Parameters belong to the scenes of the catalogue; `own` is null for a scene file.
void refuse_foreign_parameters(const std::string& scene, const SceneEntry* own, const GivenOptions& given) {
    const std::vector<std::string> known = own ? names_of(own->parameters) : std::vector<std::string>();
    for (const SceneEntry& other : catalogue()) {
        for (const Parameter& parameter : other.parameters) {
            const auto* chosen = given.find(parameter.name);
            if (!chosen || std::ranges::find(known, parameter.name) != known.end()) continue;
            throw UsageError("{} {}: scene {} has no such parameter; it has {}", chosen->field, chosen->text, scene,
                             known.empty() ? "none" : fmt::format("--{}", fmt::join(known, ", --")));
        }
    }
}

ParameterValues understand_parameters(const SceneEntry& scene, const GivenOptions& given) {
    ParameterValues values(scene.parameters);
    for (const Parameter& parameter : scene.parameters) {
        const auto* chosen = given.find(parameter.name);
        if (chosen && !values.set(parameter, chosen->text)) refuse(*chosen, parameter.allowed());
    }
    return values;
}

// Not if the name is too long.
bool is_there(const std::filesystem::path& file) {
    std::error_code ignored;
    return exists(file, ignored);
}

// A name that is neither a known scene nor a file is reported as an unknown scene.
void require_scene(const std::string& name) {
    if (find_scene(name) || name == "-" || name.ends_with(".json") || is_there(name)) return;
    const std::vector<std::string> names = names_of(catalogue());
    throw UsageError("scene {}: must be one of {}, or a scene file (.json){}", name, fmt::join(names, ", "),
                     suggestion(name, names));
}

// Fills in scene, description and parameters.
void understand_scene(const std::string& name, const GivenOptions& given, Choices& choices) {
    require_parameters(name, given);
    choices.scene = name;
    const SceneEntry* const entry = find_scene(name);
    if (!entry) {
        choices.description = read_scene_file(name);
        return;
    }
    const ParameterValues values = understand_parameters(*entry, given);
    for (const Parameter& parameter : entry->parameters) {
        choices.parameters.emplace_back(parameter.name, to_text(values.number(parameter.name)));
    }
    choices.description = entry->describe(values);
}

FrameChoices understand_frames(const GivenOptions& given) {
    FrameChoices choices;
    for (const FrameOption& option : frame_options()) {
        const auto* chosen = given.find(option.name);
        if (chosen && !option.set(choices, chosen->text)) refuse(*chosen, option.allowed);
    }
    if (choices.shutter > 0.0 && choices.samples == 1) {
        refuse(*given.find("shutter"), "0 with a single sample; --samples 16 spreads 16 over the time");
    }
    // Pictures to look at for longer than a frame of a video.
    if (!given.find("camera") && (!choices.at.empty() || choices.compare)) choices.camera = *parse_camera("fit");
    return choices;
}

std::vector<std::string> known_in_config() {
    std::vector<std::string> names = simulation_option_names();
    names.emplace_back("scene");
    for (const FrameOption& option : frame_options()) names.emplace_back(option.name);
    std::vector<std::string> parameters = parameter_names();
    std::ranges::sort(parameters);
    names.insert(names.end(), parameters.begin(), parameters.end());
    return names;
}

// The name of today for one in a file of an earlier version: `integrator` is `scheme`, and euler was what is not
// RATTLE. Empty if the option has no meaning any more, which is noted.
std::string current_name(const std::string& name, const std::string& text, const std::string& field) {
    if (name != "integrator") return name;
    if (text != "euler") return "scheme";
    note(fmt::format("{} euler: has no meaning any more", field));
    return {};
}

// A scene file as a config names it, or beside the config.
std::string found_scene(const std::filesystem::path& config, const std::string& scene) {
    const std::filesystem::path folder = config.parent_path(), given = scene;
    if (given.extension() != ".json" || is_there(given)) return scene;
    for (const std::filesystem::path& place : {folder / given, folder / given.filename()}) {
        if (is_there(place)) return place.string();
    }
    return scene;
}

}  // namespace

void GivenOptions::add(const std::string& name, const std::string& text, const std::string& field) {
    given_.try_emplace(name, Given{text, field});
}

bool GivenOptions::preset_decides(std::string_view option) const {
    const Given* const compared = find("compare");
    const bool given = find("preset") || (compared && compared->text.starts_with("preset="));
    return given && is_of_preset(option);
}

const GivenOptions::Given* GivenOptions::find(std::string_view name) const {
    const auto found = given_.find(name);
    return found == given_.end() ? nullptr : &found->second;
}

void add_config(const std::filesystem::path& file, GivenOptions& given) {
    const Json config = read_json_file(file, "--config " + file.string());
    if (!config.is_object()) {
        throw UsageError("--config {}: must be an object of option names and values", file.string());
    }
    const std::vector<std::string> known = known_in_config();
    const GivenOptions above = given;
    for (const auto& [key, value] : config.items()) {
        const std::string field = fmt::format("{} in {}", key, file.string());
        const bool is_text = value.is_string() || value.is_number();
        const std::string name = current_name(key, is_text ? text_of(value) : std::string(), field);
        if (name.empty()) continue;
        if (std::ranges::find(known, name) == known.end()) {
            throw UsageError(field + ": unknown option" + suggestion(name, known));
        }
        if (!is_text) throw UsageError("{} {}: must be a string or a number", field, json_text(value, -1));
        const std::string text = name == "scene" ? found_scene(file, text_of(value)) : text_of(value);
        if (!above.preset_decides(name)) given.add(name, text, field);
    }
    // Programs that did not fit cameras to stills did not write which camera they had.
    if (config.contains("at") || config.contains("compare")) {
        given.add("camera", "scene", fmt::format("camera in {}", file.string()));
    }
}

Choices understand(const std::string& scene, GivenOptions given) {
    Choices choices;
    understand_scene(scene, given, choices);
    const std::vector<std::string> known = simulation_option_names();
    const GivenOptions above = given;
    for (const auto& [key, text] : choices.description.options) {
        const std::string field = fmt::format("{}: options.{}", scene, key);
        const std::string name = current_name(key, text, field);
        if (name.empty()) continue;
        if (std::ranges::find(known, name) == known.end()) {
            throw UsageError(field + ": unknown key" + nearest_or_all(name, known));
        }
        // A resumed run has already been started: no preset changes its start kick.
        const bool is_over = choices.description.state && name == "start-kick";
        if (above.preset_decides(name) && !is_over) continue;
        const bool beside = name == measured_option && !find_scene(scene);
        given.add(name, beside ? (std::filesystem::path(scene).parent_path() / text).string() : text, field);
    }
    choices.settings = understand_settings(given);
    if (!choices.settings.measured.empty()) add_measured(choices.description, choices.settings.measured);
    choices.frames = understand_frames(given);
    return choices;
}

void require_parameters(const std::string& scene, const GivenOptions& given) {
    require_scene(scene);
    if (!find_scene(scene) && scene != "-" && !is_there(scene)) return;  // reading it says so
    refuse_foreign_parameters(scene, find_scene(scene), given);
}

SceneDescription spelled_out(const Choices& choices) {
    SceneDescription description = choices.description;
    description.options["preset"] = choices.settings.preset;
    for (const auto& [name, text] : texts_of(choices.settings)) description.options[name] = text;
    description.options.erase(std::string(measured_option));
    return description;
}

std::uint32_t motion_hash(const Choices& choices) {
    SceneDescription description = spelled_out(choices);
    description.name.clear();
    description.has_camera = false;
    description.standing.reset();
    for (BodyDescription& body : description.bodies) body.colour.reset();
    for (const char* const name : {"preset", "seconds", "threads"}) description.options.erase(name);
    return static_cast<std::uint32_t>(text_hash(scene_file_text(description)));
}

std::string film_mark(const Choices& choices, const GivenOptions& given) {
    if (!choices.frames.at.empty()) return "";
    Json config = parse_json(config_text(choices, given));
    // Frames are the same bytes with any of these.
    for (const char* const name : {"gl", "threads", "scene"}) config.erase(name);
    config["scene"] = choices.description.name;
    return fmt::format("{:016x}", text_hash(json_text(config)));
}

std::string config_text(const Choices& choices, const GivenOptions& given) {
    Json config;
    config["scene"] = choices.scene;
    if (choices.frames.compare) {
        for (const auto& [name, option] : given.all()) {
            if (name != "scene") config[name] = json_of(option.text);
        }
        config["camera"] = choices.frames.camera.text;
        return json_text(config);
    }
    config["preset"] = choices.settings.preset;
    for (const auto& [name, text] : texts_of(choices.settings)) config[name] = json_of(text);
    for (const auto& [name, text] : choices.parameters) {
        if (given.find(name)) config[name] = json_of(text);
    }
    for (const FrameOption& option : frame_options()) {
        const std::string text = option.get(choices.frames);
        if (!text.empty()) config[option.name] = json_of(text);
    }
    return json_text(config);
}

}  // namespace pushfactor::demos
