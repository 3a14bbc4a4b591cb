#include "demos/options/named_run.h"

#include "demos/platform/assets.h"

namespace pushfactor::demos {

Choices run_of(const std::string& scene, const OptionTexts& options) {
    GivenOptions given;
    for (const auto& [name, text] : options) given.add(name, text, "--" + name);
    if (find_scene(scene) || scene.ends_with(".json")) return understand(scene, given);
    return understand((asset_folder("scenes") / (scene + ".json")).string(), given);
}

std::string command_text(const std::string& command, const std::string& scene, const OptionTexts& options) {
    std::string text = "pushfactor " + command + " " + scene;
    for (const auto& [name, value] : options) text += " --" + name + " " + value;
    return text;
}

}  // namespace pushfactor::demos
