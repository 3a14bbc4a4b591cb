// What a check has to do, and what it finds.
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pushfactor::demos::checks {

enum class Finding { same, within_tolerance, differs, missing, unreadable, other_size };

struct PictureVerdict {
    std::string name{};  // of the file
    Finding finding = Finding::same;
    double badness = 0.0;  // by which the worst come first
    std::string text{};    // what differs, in numbers; empty if nothing does
    bool shown = false;    // the folder of the page has its pictures
    double seconds = 0.0;  // that the comparison took

    bool holds() const { return finding == Finding::same || finding == Finding::within_tolerance; }
};

// About a run as a whole: its physics, its options.
struct RunVerdict {
    std::string subject;  // "physics", "options", "run"
    bool holds = true;
    std::string text;
    bool compared = true;  // otherwise the text says why not
};

struct FolderVerdict {
    std::string name;    // the folder as it was given
    std::string anchor;  // of its pictures and on the page: unique, a file name
    std::string how;     // its pictures were compared: "to the byte", or the tolerance
    std::vector<PictureVerdict> pictures{};
    std::vector<RunVerdict> runs{};
    std::vector<std::string> unexpected{};  // names of pictures that are not of this run, and so not compared
    double seconds = 0.0;                   // that the check took
    bool made = true;                       // its run, to the end

    long not_compared() const {
        return std::count_if(runs.begin(), runs.end(), [](const auto& one) { return !one.compared; });
    }
    long differing() const {
        return std::count_if(pictures.begin(), pictures.end(), [](const auto& one) { return !one.holds(); });
    }
    long failures() const {
        return differing() + std::count_if(runs.begin(), runs.end(), [](const auto& one) { return !one.holds; });
    }
};

// What there is to do and where its pictures go.
struct FolderJob {
    std::string name;             // of the verdict
    std::string anchor;           // of the verdict
    std::filesystem::path pages;  // folder of the page
    std::function<void(long)> progress = [](long) {};
};

}  // namespace pushfactor::demos::checks
