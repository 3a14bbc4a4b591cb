#include "demos/pictures/live/menu.h"

#include "demos/options/simulation_options.h"
#include "demos/pictures/replay/stage.h"
#include "demos/platform/version.h"
#include "demos/scenes/catalogue.h"

namespace pushfactor::demos::pictures::live {

namespace {

Json scenes() {
    Json scenes = Json::array();
    for (const SceneEntry& entry : catalogue()) {
        Json parameters = Json::array();
        for (const Parameter& parameter : entry.parameters) {
            parameters.push_back({{"name", parameter.name},
                                  {"help", parameter.help},
                                  {"value", parameter.fallback},
                                  {"low", parameter.low},
                                  {"high", parameter.high},
                                  {"whole", parameter.whole}});
        }
        scenes.push_back(
            {{"name", entry.name}, {"sentence", entry.sentence}, {"parameters", std::move(parameters)}});
    }
    return scenes;
}

Json options() {
    Json options = Json::array();
    for (const SimulationOption& option : simulation_options()) {
        if (!is_on_menu(option.name)) continue;
        Json values = Json::object();
        for (const Preset& preset : presets()) values[std::string(preset.name)] = option.get(preset.settings());
        options.push_back({{"name", option.name},
                           {"help", option.help},
                           {"allowed", option.allowed},
                           {"values", std::move(values)}});
    }
    return options;
}

}  // namespace

bool is_on_menu(std::string_view option) {
    return option != "seconds" && option != "threads";
}

Json menu() {
    Json named = Json::array();
    for (const Preset& preset : presets()) named.push_back({{"name", preset.name}, {"help", preset.description}});
    return {{"scenes", scenes()},
            {"presets", std::move(named)},
            {"options", options()},
            {"legend", replay::legend_of_arrows()},
            {"version", version_text()}};
}

}  // namespace pushfactor::demos::pictures::live
