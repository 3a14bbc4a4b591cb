#include "demos/commands/commands.h"
#include "demos/scenes/catalogue.h"

#include <fmt/format.h>

namespace pushfactor::demos::commands {

void list(const Request& request) {
    for (const SceneEntry& scene : catalogue()) {
        if (request.names_only) {
            fmt::print("{}\n", scene.name);
            continue;
        }
        const SceneDescription description = scene.describe(ParameterValues(scene.parameters));
        fmt::print("{}\n    {}\n    made of: {}\n", scene.name, scene.sentence, made_of(description));
        for (const Parameter& parameter : scene.parameters) {
            fmt::print("    {:<16} {}\n", fmt::format("--{} {}", parameter.name, parameter.placeholder),
                       parameter.help);
        }
        fmt::print("\n");
    }
}

}  // namespace pushfactor::demos::commands
