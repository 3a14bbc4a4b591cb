// The command report merge: which report the pieces in some folders are of.
#pragma once

#include "demos/commands/request.h"

#include <filesystem>
#include <string>
#include <vector>

namespace pushfactor::demos::commands {

// What a share of a report leaves with its pieces.
struct ReportNote {
    std::vector<std::string> words;  // of the command that makes the whole report, without the program's name
    int shards = 1;
};

std::string note_text(const ReportNote& note);

struct Merge {
    Request request;  // of the whole report
    std::vector<std::filesystem::path> folders;
    ReportNote note;
};

// `request` is that of `report merge DIR...`. Throws UsageError for folders without pieces, with those of several
// versions or of another than this, or of several reports.
Merge understand_merge(const Request& request);

// Prints the missing pieces and the commands that make them.
void print_missing(const Merge& merge, const std::vector<std::string>& keys);

}  // namespace pushfactor::demos::commands
