#include "demos/pictures/replay/replay.h"
#include "demos/reports/pieces/piece.h"

namespace pushfactor::demos::reports {

std::string replay_of(const std::string& scene, const OptionTexts& options, const std::function<void()>& check) {
    const StagedFile file(std::filesystem::temp_directory_path() / "replay", ".html");  // removed at the end
    const Choices choices = run_of(scene, options);
    Session session({.panels = {{.label = "", .choices = choices}}, .frames = {pictures::replay_frames(choices)}});
    pictures::Replay replay({.file = file.path(),
                             .poses_only = true,
                             .command = command_text("run", scene, options) + " --replay replay.html"},
                            session);
    try {
        session.play({&replay}, [&](const Simulation&) {
            check();
            return true;
        });
        replay.finish();
    } catch (const NonFiniteError& error) {
        replay.finish(error.what());
    }
    return read_bytes_of(file.path()).value_or("");
}

}  // namespace pushfactor::demos::reports
