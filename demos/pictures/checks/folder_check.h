// Pictures against those of a folder.
#pragma once

#include "demos/pictures/checks/comparison.h"
#include "demos/pictures/checks/expectation.h"
#include "demos/pictures/offscreen_renderer.h"

namespace pushfactor::demos::checks {

struct Rules {
    std::optional<Tolerance> tolerance{};  // none: exactly() for the same program and driver, else usual()
    bool physics = true;                   // compare it; without, there is no `trajectory`
    std::optional<double> trajectory{};    // m and rad: within that of trajectory.csv, instead of the state hash
};

// New files for a folder, beside it until all of them are there. Until apply() the folder is as it was; without it
// the new files are removed again.
class Update {
  public:
    // Throws OutputError if nothing can be written in `folder`.
    explicit Update(std::filesystem::path folder);
    Update(const Update&) = delete;
    Update& operator=(const Update&) = delete;
    ~Update();

    // Path of a new file, for others to write.
    std::filesystem::path staged(const std::string& name) const { return staging_ / name; }

    // Replaces the files of the folder by the new ones. Returns their number. Throws OutputError.
    long apply();

  private:
    std::filesystem::path folder_, staging_;
};

// Renders the expectation again and compares. New pictures and the new summary go to `update` unless it is null. A
// run that becomes non-finite is a verdict. Throws RunError when interrupted.
FolderVerdict check_folder(const Expectation& expected, const Rules& rules, const FolderJob& job,
                           pictures::OffscreenRenderer& offscreen, Update* update);

// Compares the PNG files of two folders and of the folders below them, by name; nothing is rendered, and no run of
// this program has to have made them.
FolderVerdict check_pictures(const std::filesystem::path& expected, const std::filesystem::path& actual,
                             const Tolerance& tolerance, const FolderJob& job);

}  // namespace pushfactor::demos::checks
