#include "demos/options/named_run.h"

#include "demos/platform/assets.h"
#include "demos/platform/shell_words.h"

namespace pushfactor::demos {

Choices run_of(const std::string& scene, const OptionTexts& options) {
    GivenOptions given;
    for (const auto& [name, text] : options) given.add(name, text, "--" + name);
    if (find_scene(scene) || scene.ends_with(".json")) return understand(scene, given);
    return understand((asset_folder("scenes") / (scene + ".json")).string(), given);
}

std::string command_text(const std::string& command, const std::string& scene, const OptionTexts& options) {
    std::vector<std::string> words{command, scene};
    for (const auto& [name, value] : options) words.insert(words.end(), {"--" + name, value});
    return command_of(words);
}

}  // namespace pushfactor::demos
