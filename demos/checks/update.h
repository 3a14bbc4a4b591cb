// New files for a folder that are kept beside it until all of them are there.
#pragma once

#include "demos/checks/comparison.h"

#include <filesystem>
#include <string_view>

namespace pushfactor::demos::checks {

// Until apply() the folder is as it was; without it the new files are removed again.
class Update {
  public:
    // Throws OutputError if nothing can be written in `folder`.
    explicit Update(std::filesystem::path folder);
    Update(const Update&) = delete;
    Update& operator=(const Update&) = delete;
    ~Update();

    // Path of a new file, for others to write.
    std::filesystem::path staged(const std::string& name) const { return staging_ / name; }
    void stage(const std::string& name, const Bytes& bytes) const;
    void stage(const std::string& name, std::string_view text) const;

    void drop(const std::string& name) const;

    // Replaces the files of the folder by the new ones. Returns their number. Throws OutputError.
    long apply();

  private:
    std::filesystem::path folder_, staging_;
};

}  // namespace pushfactor::demos::checks
