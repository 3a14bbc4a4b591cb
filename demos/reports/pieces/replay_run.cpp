#include "demos/reports/pieces/replay_run.h"

#include "demos/pictures/replay/replay.h"
#include "demos/reports/study.h"

#include <cstdlib>

namespace pushfactor::demos::reports {

namespace {

namespace fs = std::filesystem;

// A temporary folder, removed with the object.
class Scratch {
  public:
    Scratch() {
        std::string name = (fs::temp_directory_path() / "pushfactor-XXXXXX").string();
        if (!mkdtemp(name.data())) throw OutputError(name + ": cannot be created");
        path_ = name;
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

}  // namespace

std::string replay_of(const std::string& scene, const OptionTexts& options, const std::function<void()>& check) {
    const Scratch folder;
    const fs::path file = folder.path() / "replay.html";
    const Choices choices = run_of(scene, options);
    Session session({.panels = {{.label = "", .choices = choices}}, .frames = {pictures::replay_frames(choices)}});
    pictures::Replay replay({.file = file,
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
    return read_bytes_of(file).value_or("");
}

}  // namespace pushfactor::demos::reports
