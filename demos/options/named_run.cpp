#include "demos/options/named_run.h"

#include "demos/base/platform/assets.h"
#include "demos/base/platform/shell_words.h"

#include <algorithm>

namespace pushfactor::demos {

OptionTexts awake(OptionTexts options) {
    const auto decides = [](const auto& option) {
        return option.first == "rest" || std::ranges::any_of(presets(), [&](const Preset& preset) {
                   return option.first == "preset" && option.second == preset.name && !preset.settings().rest;
               });
    };
    if (std::ranges::none_of(options, decides)) options.emplace_back("rest", "off");
    return options;
}

Choices run_of(const std::string& scene, const OptionTexts& options) {
    GivenOptions given;
    for (const auto& [name, text] : awake(options)) given.add(name, text, "--" + name);
    if (find_scene(scene) || scene.ends_with(".json")) return understand(scene, given);
    return understand((asset_folder("scenes") / (scene + ".json")).string(), given);
}

std::string command_text(const std::string& command, const std::string& scene, const OptionTexts& options) {
    std::vector<std::string> words{command, scene};
    for (const auto& [name, value] : awake(options)) words.insert(words.end(), {"--" + name, value});
    return command_of(words);
}

}  // namespace pushfactor::demos
