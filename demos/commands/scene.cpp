#include "demos/commands/commands.h"
#include "demos/output_file.h"
#include "demos/scene_file.h"
#include "demos/simulation_options.h"

namespace pushfactor::demos::commands {

void scene(const Request& request) {
    const Choices choices = understand(request.scenes.front(), request.given);
    SceneDescription description = choices.description;
    // Every option is spelled out, so that the file means the same when a preset changes.
    description.options["preset"] = choices.settings.preset;
    for (const SimulationOption& option : simulation_options()) {
        const std::string text = option.get(choices.settings);
        if (!text.empty()) description.options[std::string(option.name)] = text;
    }
    write_file("-", scene_file_text(description));
}

}  // namespace pushfactor::demos::commands
