#include "demos/pictures/caption.h"

#include "demos/options/simulation_options.h"
#include "demos/text/numbers.h"

namespace pushfactor::demos::pictures {

std::string caption_of(const Choices& choices) {
    const std::string compared = choices.frames.compare ? choices.frames.compare->option : "";
    std::string caption = choices.description.name;
    const auto add = [&](const std::string& name, const std::string& value) {
        if (name != compared) caption += "   " + name + " " + value;
    };
    add("preset", choices.settings.preset);
    const Settings preset = preset_settings(choices.settings.preset);
    for (const SimulationOption& option : simulation_options()) {
        const std::string value = option.get(choices.settings);
        if (option.name != "seconds" && value != option.get(preset)) add(std::string(option.name), value);
    }
    const SceneEntry* const scene = find_scene(choices.scene);
    for (std::size_t i = 0; scene && i < scene->parameters.size(); ++i) {
        const Parameter& parameter = scene->parameters[i];
        const auto& [name, value] = choices.parameters[i];
        if (value != to_text(parameter.fallback)) add(name, value);
    }
    return caption;
}

}  // namespace pushfactor::demos::pictures
