#include "demos/base/platform/output_file.h"
#include "demos/commands/commands.h"
#include "demos/scenes/catalogue.h"

#include <fmt/format.h>

namespace pushfactor::demos::commands {

namespace {

std::vector<Option> list_options() {
    return {{"names", "", "only the names, one per line"}};
}

AnyCommand read_list(Words& words) {
    return List{.names_only = words.take_flag("names")};
}

std::string text_of(const SceneEntry& scene) {
    const SceneDescription description = scene.describe(ParameterValues(scene.parameters));
    std::string text =
        fmt::format("{}\n    {}\n    made of: {}\n", scene.name, scene.sentence, made_of(description));
    for (const Parameter& parameter : scene.parameters) {
        text += fmt::format("    {:<16} {}\n", fmt::format("--{} {}", parameter.name, parameter.placeholder),
                            parameter.help);
    }
    return text + "\n";
}

}  // namespace

void carry_out(const List& command) {
    for (const SceneEntry& scene : catalogue()) {
        print(command.names_only ? std::string(scene.name) + "\n" : text_of(scene));
    }
}

const Entry list_entry{"list", "", "the scenes: what happens, what they are made of, their parameters",
                       list_options, read_list};

}  // namespace pushfactor::demos::commands
