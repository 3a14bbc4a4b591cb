#include "demos/base/platform/output_file.h"
#include "demos/base/platform/shell_words.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/shard.h"
#include "demos/commands/report.h"
#include "demos/reports/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace pushfactor::demos::commands {

namespace {

namespace fs = std::filesystem;

// The only version of all folders, which is that of this program.
void require_one_version(const std::vector<fs::path>& folders) {
    std::map<std::string, fs::path> versions;
    for (const fs::path& folder : folders) {
        const std::set<std::string> here = reports::piece_versions_in(folder);
        if (here.empty()) {
            throw UsageError("merge {}: must have pieces, as `report NAME --shard K/N --out {}` makes them",
                             folder.string(), folder.string());
        }
        for (const std::string& version : here) versions.emplace(version, folder / "pieces" / version);
    }
    if (versions.size() > 1) {
        const auto& [first, in_first] = *versions.begin();
        const auto& [last, in_last] = *versions.rbegin();
        throw UsageError("merge: pieces must be of one version, not of {} ({}) and {} ({})", first,
                         in_first.string(), last, in_last.string());
    }
    const auto& [version, place] = *versions.begin();
    if (version == reports::piece_version()) return;
    throw UsageError("merge {}: must be of the version of this program, {}", place.string(),
                     reports::piece_version());
}

ReportNote read_note(const fs::path& folder) {
    const auto text = reports::piece_note_in(folder);
    const Json json = text ? json_or_null(*text) : Json();
    const bool sound = json.is_object() && json.contains("words") && json["words"].is_array() &&
                       json["words"].size() >= 2 &&
                       std::ranges::all_of(json["words"], [](const Json& word) { return word.is_string(); }) &&
                       json.contains("shards") && json["shards"].is_number_integer() && json["shards"] > 0;
    if (!sound) {
        throw UsageError("merge {}: must have the report.json that `report` leaves with its pieces",
                         folder.string());
    }
    return {json["words"].get<std::vector<std::string>>(), json["shards"].get<int>()};
}

// The report of all folders, which must be one.
ReportNote note_of(const std::vector<fs::path>& folders) {
    ReportNote common;
    for (const fs::path& folder : folders) {
        ReportNote note = read_note(folder);
        if (!common.words.empty() && note.words != common.words) {
            throw UsageError("merge: must be of one report, not `{}` ({}) and `{}` ({})", command_of(common.words),
                             folders.front().string(), command_of(note.words), folder.string());
        }
        note.shards = std::max(note.shards, common.shards);
        common = std::move(note);
    }
    return common;
}

// Prints the missing pieces and the commands that make them.
void print_missing(const ReportNote& note, const fs::path& folder, const std::vector<std::string>& keys) {
    constexpr std::size_t most = 20;
    std::map<int, std::size_t> shards;  // missing pieces of each
    for (const std::string& key : keys) {
        const auto count = static_cast<std::uint64_t>(note.shards);
        ++shards[static_cast<int>(text_hash(key) % count) + 1];
    }
    for (std::size_t i = 0; i < std::min(keys.size(), most); ++i) print(fmt::format("missing: {}\n", keys[i]));
    if (keys.size() > most) print(fmt::format("and {} more\n", keys.size() - most));
    print("made by:\n");
    for (const auto& [number, missing] : shards) {
        std::vector<std::string> words = note.words;
        if (note.shards > 1) words.insert(words.end(), {"--shard", to_text(Shard{number, note.shards})});
        words.insert(words.end(), {"--out", folder.string()});
        print(fmt::format("{}    # {}\n", command_of(words), missing));
    }
}

}  // namespace

std::string note_text(const ReportNote& note) {
    return json_text(Json{{"words", note.words}, {"shards", note.shards}});
}

AnyCommand read_merge(Words& words) {
    Merge command{.folders = words.take_names(),
                  .out = words.take("out"),
                  .junit = words.take("junit"),
                  .markdown = words.take("markdown")};
    command.folders.erase(command.folders.begin());
    if (command.folders.empty()) throw UsageError("merge: must have the folders of shards: report merge DIR...");
    words.refuse_rest("report merge, which does what the shards did");
    return command;
}

void carry_out(const Merge& command) {
    const std::vector<fs::path> folders(command.folders.begin(), command.folders.end());
    require_one_version(folders);
    const ReportNote note = note_of(folders);
    std::vector<std::string> all(note.words.begin() + 1, note.words.end());
    if (command.junit) all.insert(all.end(), {"--junit", *command.junit});
    if (command.markdown) all.insert(all.end(), {"--markdown", *command.markdown});
    Words words("report", report_options(), all);
    Report report = read_report(words, words.take_names().front());
    report.out = !command.out && folders.size() == 1 ? command.folders.front() : command.out;
    try {
        make_report(report, folders);
    } catch (const reports::MissingPieces& missing) {
        print_missing(note, folders.front(), missing.keys);
        throw;
    }
}

}  // namespace pushfactor::demos::commands
