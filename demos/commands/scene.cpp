#include "demos/commands/commands.h"
#include "demos/platform/output_file.h"
#include "demos/scenes/scene_file.h"

namespace pushfactor::demos::commands {

void scene(const Request& request) {
    const Choices choices = understand(request.scenes.front(), request.given);
    write_file("-", scene_file_text(spelled_out(choices)));
}

}  // namespace pushfactor::demos::commands
