#include "demos/base/platform/output_file.h"
#include "demos/commands/commands.h"
#include "demos/commands/run_options.h"
#include "demos/options/comparison.h"
#include "demos/scenes/scene_file.h"

namespace pushfactor::demos::commands {

namespace {

AnyCommand read_scene(Words& words) {
    std::vector<std::string> scenes = words.take_names();
    GivenOptions given = take_simulation(words, scenes, true);
    return Scene{.scene = only_scene(scenes), .given = std::move(given)};
}

}  // namespace

void carry_out(const Scene& command) {
    const ComparedRun run{.label = "", .choices = understand(command.scene, command.given)};
    note_idle(command.given, std::span(&run, 1));
    write_file("-", scene_file_text(spelled_out(run.choices)));
}

const Entry scene_entry{"scene",
                        "SCENE",
                        "prints a scene as a JSON file that run and render accept",
                        simulation_option_table,
                        read_scene,
                        scene_parameters_help};

}  // namespace pushfactor::demos::commands
