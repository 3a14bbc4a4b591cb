// What report and report merge share.
#pragma once

#include "demos/commands/commands.h"

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

std::vector<Option> report_options();

// Takes the options of this report. Throws UsageError.
Report read_report(Words& words, const std::string& name);
AnyCommand read_merge(Words& words);

// `merged`: folders that have all pieces; if empty the pieces are made.
void make_report(const Report& report, const std::vector<std::filesystem::path>& merged);

}  // namespace pushfactor::demos::commands
