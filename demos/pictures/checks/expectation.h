// A folder of `render` as an expectation: how its pictures were made, and what its summary says.
#pragma once

#include "demos/base/text/json.h"
#include "demos/pictures/checks/verdict.h"
#include "demos/runs/session.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos::checks {

struct Expectation {
    std::filesystem::path folder;
    GivenOptions given;
    Sequence sequence;
    std::optional<Json> summary;  // summary.json, as it was written with the pictures

    // Whether this program with `driver` made the pictures; unknown for a program that was modified.
    bool was_made_with(const std::string& driver) const;

    // Names of the PNG files in the folder that are none of its frames, in order.
    std::vector<std::string> unexpected() const;
};

inline const char* const config_file = "config.json";

// The folders below `folder`, itself included, that have pictures or a config.json, by name. Throws UsageError if
// none has a config.json.
std::vector<std::filesystem::path> folders_of_pictures(const std::filesystem::path& folder);

// `given` takes precedence over the config. Throws UsageError, one line, also for a folder that a newer version of
// the program wrote.
Expectation read_expectation(const std::filesystem::path& folder, const GivenOptions& given);

bool is_png(const std::filesystem::path& file);

// All files of a folder and those below it, through links, in order. Throws UsageError for what is no folder, and
// for one that cannot be read.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder);

// The options and the physics of the new run against those of the expectation: each panel's options by name, and
// its state hash unless `hash` is false.
std::vector<RunVerdict> compare_runs(const Expectation& expected, const Json& summary, bool hash);

}  // namespace pushfactor::demos::checks
