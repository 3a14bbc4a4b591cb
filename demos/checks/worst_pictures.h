// The pictures of a page: expected, actual and their difference, of the worst that were found in a folder.
#pragma once

#include "demos/checks/comparison.h"
#include "demos/text/text_hash.h"

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos::checks {

// A picture's name without what would make a file name too long.
inline std::string short_file_name(const std::string& name) {
    constexpr std::size_t longest = 200;
    const std::size_t slash = name.rfind('/'), begin = slash == std::string::npos ? 0 : slash + 1;
    if (name.size() - begin <= longest) return name;
    return name.substr(0, begin + longest - 17) + "-" + std::to_string(text_hash(name) % 1000000000000000u);
}

// Names of the files in the folder of the page.
inline std::string expected_file(const std::string& name) {
    return short_file_name(name) + ".expected.png";
}
inline std::string actual_file(const std::string& name) {
    return short_file_name(name) + ".actual.png";
}
inline std::string difference_file(const std::string& name) {
    return short_file_name(name) + ".difference.png";
}

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
    void write(const Compared& compared) const;
    void remove(const std::string& name) const;

    std::filesystem::path folder_;
    std::set<std::pair<double, std::string>> kept_;  // badness and name
};

}  // namespace pushfactor::demos::checks
