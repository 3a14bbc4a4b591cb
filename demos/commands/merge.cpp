#include "demos/commands/merge.h"

#include "demos/commands/command_line.h"
#include "demos/reports/pieces/store.h"
#include "demos/text/errors.h"
#include "demos/text/shard.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

namespace pushfactor::demos::commands {

namespace {

namespace fs = std::filesystem;
using reports::PieceStore;

std::string command_of(const std::vector<std::string>& words) {
    std::string text = "pushfactor";
    for (const std::string& word : words) text += " " + quoted(word);
    return text;
}

// The only version of all folders, which is that of this program.
void require_one_version(const std::vector<fs::path>& folders) {
    std::map<std::string, fs::path> versions;
    for (const fs::path& folder : folders) {
        const std::set<std::string> here = PieceStore::versions_in(folder);
        if (here.empty()) {
            throw UsageError(
                fmt::format("merge {}: must have pieces, as `report NAME --shard K/N --out {}` makes them",
                            folder.string(), folder.string()));
        }
        for (const std::string& version : here) versions.emplace(version, folder / "pieces" / version);
    }
    if (versions.size() > 1) {
        const auto& [first, in_first] = *versions.begin();
        const auto& [last, in_last] = *versions.rbegin();
        throw UsageError(fmt::format("merge: pieces must be of one version, not of {} ({}) and {} ({})", first,
                                     in_first.string(), last, in_last.string()));
    }
    const auto& [version, place] = *versions.begin();
    if (version == PieceStore::version_folder()) return;
    throw UsageError(fmt::format("merge {}: must be of the version of this program, {}", place.string(),
                                 PieceStore::version_folder()));
}

ReportNote read_note(const fs::path& folder) {
    const auto text = PieceStore::note_of(folder);
    const Json json = text ? Json::parse(*text, nullptr, false) : Json();
    const bool sound = json.is_object() && json.contains("words") && json["words"].is_array() &&
                       json["words"].size() >= 2 && json.contains("shards") && json["shards"].is_number_integer();
    if (!sound) {
        throw UsageError(fmt::format("merge {}: must have the report.json that `report` leaves with its pieces",
                                     folder.string()));
    }
    return {json["words"].get<std::vector<std::string>>(), json["shards"].get<int>()};
}

Request parsed(const std::vector<std::string>& words) {
    std::vector<std::string> all{"pushfactor"};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> arguments;
    for (std::string& word : all) arguments.push_back(word.data());
    return parse_command_line(static_cast<int>(arguments.size()), arguments.data()).value();
}

}  // namespace

std::string note_text(const ReportNote& note) {
    return Json{{"words", note.words}, {"shards", note.shards}}.dump(2) + "\n";
}

Merge understand_merge(const Request& request) {
    Merge merge;
    for (std::size_t i = 1; i < request.reports.size(); ++i) merge.folders.emplace_back(request.reports[i]);
    if (merge.folders.empty()) throw UsageError("merge: must have the folders of shards: report merge DIR...");
    for (const auto& [option, given] :
         {std::pair{"--shard", request.shard.has_value()}, std::pair{"--quick", request.quick},
          std::pair{"--only", !request.parts.empty()}, std::pair{"--grid", request.grid.scene.has_value()},
          std::pair{"--export", request.exported.has_value()}}) {
        if (given)
            throw UsageError(fmt::format("{}: must not be with merge, which does what the shards did", option));
    }
    require_one_version(merge.folders);
    for (const fs::path& folder : merge.folders) {
        ReportNote note = read_note(folder);
        if (!merge.note.words.empty() && note.words != merge.note.words) {
            throw UsageError(fmt::format("merge: must be of one report, not `{}` ({}) and `{}` ({})",
                                         command_of(merge.note.words), merge.folders.front().string(),
                                         command_of(note.words), folder.string()));
        }
        note.shards = std::max(note.shards, merge.note.shards);
        merge.note = std::move(note);
    }
    merge.request = parsed(merge.note.words);
    merge.request.junit = request.junit;
    merge.request.markdown = request.markdown;
    merge.request.out = request.out;
    if (!request.out && merge.folders.size() == 1) merge.request.out = merge.folders.front().string();
    return merge;
}

void print_missing(const Merge& merge, const std::vector<std::string>& keys) {
    constexpr std::size_t most = 20;
    std::map<int, std::size_t> shards;  // missing pieces of each
    for (const std::string& key : keys) {
        const auto count = static_cast<std::uint64_t>(merge.note.shards);
        ++shards[static_cast<int>(reports::hash_of_key(key) % count) + 1];
    }
    for (std::size_t i = 0; i < std::min(keys.size(), most); ++i) fmt::print("missing: {}\n", keys[i]);
    if (keys.size() > most) fmt::print("and {} more\n", keys.size() - most);
    fmt::print("made by:\n");
    for (const auto& [number, missing] : shards) {
        std::vector<std::string> words = merge.note.words;
        if (merge.note.shards > 1) {
            words.insert(words.end(), {"--shard", to_text(Shard{number, merge.note.shards})});
        }
        words.insert(words.end(), {"--out", merge.folders.front().string()});
        fmt::print("{}    # {}\n", command_of(words), missing);
    }
}

}  // namespace pushfactor::demos::commands
