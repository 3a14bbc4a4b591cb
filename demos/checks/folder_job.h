#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace pushfactor::demos::checks {

// What there is to do and where its pictures go.
struct FolderJob {
    std::string name;             // of the verdict
    std::string anchor;           // of the verdict
    std::filesystem::path pages;  // folder of the page
    std::function<void(long)> progress = [](long) {};
};

}  // namespace pushfactor::demos::checks
