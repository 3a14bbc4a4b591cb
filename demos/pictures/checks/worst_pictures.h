// The pictures of a page: expected, actual and their difference, of the worst that were found in a folder.
#pragma once

#include "demos/pictures/checks/comparison.h"

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos::checks {

// Name of a file in the folder of the page: of a picture the `exhibit` "expected", "actual" or "difference".
std::string exhibit_file(const std::string& name, const std::string& exhibit);

class WorstPictures {
  public:
    static constexpr std::size_t most = 20;

    // Pictures go to `folder`, which is made with the first one. Those of an earlier check are removed.
    explicit WorstPictures(std::filesystem::path folder);

    // Keeps the pictures on disk while they are among the worst.
    void offer(const Compared& compared);

    // Marks the verdicts whose pictures are there.
    void mark(std::vector<PictureVerdict>& verdicts) const;

  private:
    std::filesystem::path folder_;
    std::set<std::pair<double, std::string>> kept_;  // badness and name
};

}  // namespace pushfactor::demos::checks
