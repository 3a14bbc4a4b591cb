#include "demos/choices.h"

#include "demos/errors.h"
#include "demos/json.h"
#include "demos/simulation_options.h"
#include "demos/suggest.h"

#include <fmt/format.h>

#include <fstream>
#include <set>

namespace pushfactor::demos {

namespace {

[[noreturn]] void refuse(const GivenOptions::Given& given, std::string_view allowed) {
    throw UsageError(fmt::format("{} {}: must be {}", given.field, given.text, allowed));
}

std::string text_of(const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

const SceneEntry& scene_named(const std::string& name) {
    if (const SceneEntry* entry = find_scene(name)) return *entry;
    std::vector<std::string> names;
    for (const SceneEntry& entry : catalogue()) names.emplace_back(entry.name);
    throw UsageError(
        fmt::format("scene {}: must be one of {}{}", name, fmt::join(names, ", "), suggestion(name, names)));
}

Settings understand_settings(const GivenOptions& given) {
    std::string preset = "default";
    if (const auto* chosen = given.find("preset")) {
        std::vector<std::string> names;
        for (const Preset& known : presets()) names.emplace_back(known.name);
        if (std::find(names.begin(), names.end(), chosen->text) == names.end()) {
            refuse(*chosen, fmt::format("one of {}", fmt::join(names, ", ")));
        }
        preset = chosen->text;
    }
    Settings settings = preset_settings(preset);
    for (const SimulationOption& option : simulation_options()) {
        const auto* chosen = given.find(option.name);
        if (chosen && !option.set(settings, chosen->text)) refuse(*chosen, option.allowed);
    }
    return settings;
}

ParameterValues understand_parameters(const SceneEntry& scene, const GivenOptions& given) {
    ParameterValues values(scene.parameters);
    for (const Parameter& parameter : scene.parameters) {
        const auto* chosen = given.find(parameter.name);
        if (chosen && !values.set(parameter, chosen->text)) refuse(*chosen, parameter.allowed());
    }
    for (const SceneEntry& other : catalogue()) {
        for (const Parameter& parameter : other.parameters) {
            const auto* chosen = given.find(parameter.name);
            const bool own = std::any_of(scene.parameters.begin(), scene.parameters.end(),
                                         [&](const Parameter& mine) { return mine.name == parameter.name; });
            if (!chosen || own) continue;
            std::vector<std::string> names;
            for (const Parameter& mine : scene.parameters) names.push_back("--" + std::string(mine.name));
            throw UsageError(fmt::format("{} {}: scene {} has no such parameter; it has {}", chosen->field,
                                         chosen->text, scene.name, fmt::join(names, ", ")));
        }
    }
    return values;
}

FrameChoices understand_frames(const GivenOptions& given) {
    FrameChoices choices;
    for (const FrameOption& option : frame_options()) {
        const auto* chosen = given.find(option.name);
        if (chosen && !option.set(choices, chosen->text)) refuse(*chosen, option.allowed);
    }
    return choices;
}

}  // namespace

void GivenOptions::add(const std::string& name, const std::string& text, const std::string& field) {
    given_.try_emplace(name, Given{text, field});
}

const GivenOptions::Given* GivenOptions::find(std::string_view name) const {
    const auto found = given_.find(name);
    return found == given_.end() ? nullptr : &found->second;
}

std::vector<std::string> known_options() {
    std::vector<std::string> names{"preset"};
    for (const SimulationOption& option : simulation_options()) names.emplace_back(option.name);
    for (const FrameOption& option : frame_options()) names.emplace_back(option.name);
    std::set<std::string> parameters;
    for (const SceneEntry& scene : catalogue()) {
        for (const Parameter& parameter : scene.parameters) parameters.emplace(parameter.name);
    }
    names.insert(names.end(), parameters.begin(), parameters.end());
    return names;
}

void add_config(const std::filesystem::path& file, GivenOptions& given) {
    std::ifstream stream(file);
    if (!stream) throw UsageError(fmt::format("--config {}: cannot be read", file.string()));
    Json config;
    try {
        config = Json::parse(stream);
    } catch (const Json::parse_error& error) {
        throw UsageError(fmt::format("--config {}: is no JSON at byte {}", file.string(), error.byte));
    }
    if (!config.is_object()) {
        throw UsageError(fmt::format("--config {}: must be an object of option names and values", file.string()));
    }
    std::vector<std::string> known = known_options();
    known.emplace_back("scene");
    for (const auto& [name, value] : config.items()) {
        const std::string field = fmt::format("{} in {}", name, file.string());
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            throw UsageError(field + ": unknown option" + suggestion(name, known));
        }
        if (!value.is_string() && !value.is_number()) {
            throw UsageError(fmt::format("{} {}: must be a string or a number", field, value.dump()));
        }
        given.add(name, text_of(value), field);
    }
}

Choices understand(const std::string& scene, const GivenOptions& given) {
    const SceneEntry& entry = scene_named(scene);
    return {.scene = &entry,
            .settings = understand_settings(given),
            .parameters = understand_parameters(entry, given),
            .frames = understand_frames(given)};
}

std::string config_text(const Choices& choices, const GivenOptions& given) {
    Json config;
    config["scene"] = choices.scene->name;
    config["preset"] = choices.settings.preset;
    for (const SimulationOption& option : simulation_options()) {
        const std::string text = option.get(choices.settings);
        if (!text.empty()) config[std::string(option.name)] = json_of(text);
    }
    for (const Parameter& parameter : choices.scene->parameters) {
        if (const auto* chosen = given.find(parameter.name))
            config[std::string(parameter.name)] = json_of(chosen->text);
    }
    for (const FrameOption& option : frame_options()) {
        const std::string text = option.get(choices.frames);
        if (!text.empty()) config[std::string(option.name)] = json_of(text);
    }
    return config.dump(2) + "\n";
}

}  // namespace pushfactor::demos
