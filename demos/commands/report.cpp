#include "demos/commands/commands.h"
#include "demos/commands/merge.h"
#include "demos/reports/study.h"
#include "demos/text/errors.h"
#include "demos/text/suggest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pushfactor::demos::commands {

namespace {

void require_known(const char* what, const std::string& name, const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    throw UsageError(
        fmt::format("{} {}: must be one of {}{}", what, name, fmt::join(known, ", "), suggestion(name, known)));
}

// The file, or all of a folder, by name.
std::vector<std::filesystem::path> problem_files(const std::filesystem::path& given) {
    if (!std::filesystem::is_directory(given)) return {given};
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(given)) {
        if (entry.path().extension() == ".hdf5") files.push_back(entry.path());
    }
    if (files.empty()) {
        throw UsageError(fmt::format("--problems {}: must have files that end in .hdf5", given.string()));
    }
    std::sort(files.begin(), files.end());
    return files;
}

// The command without what does not change results: that of the whole report.
std::vector<std::string> deciding_words(const Request& request) {
    std::vector<std::string> words{"report", request.reports.front()};
    const auto add = [&words](const char* option, const std::optional<std::string>& value) {
        if (value) words.insert(words.end(), {option, *value});
    };
    if (request.quick) words.emplace_back("--quick");
    if (!request.parts.empty()) add("--only", fmt::format("{}", fmt::join(request.parts, ",")));
    add("--problems", request.problems);
    add("--beside", request.beside);
    const GridWords& grid = request.grid;
    add("--grid", grid.scene);
    add("--x", grid.x);
    add("--y", grid.y);
    add("--measure", grid.measure);
    for (const std::string& text : grid.set) add("--set", text);
    if (!grid.replays.empty()) add("--replays", fmt::format("{}", fmt::join(grid.replays, ",")));
    return words;
}

// Options of one report, given with another.
void refuse_foreign(const Request& request, const reports::Study& study) {
    for (const auto& [option, value] :
         {std::pair{"--problems", request.problems}, std::pair{"--beside", request.beside},
          std::pair{"--export", request.exported}}) {
        if (value && study.name != "error") {
            throw UsageError(
                fmt::format("{} {}: must be with report error, the only one that has problems", option, *value));
        }
    }
    for (const auto& [option, file] :
         {std::pair{"--junit", request.junit}, std::pair{"--markdown", request.markdown}}) {
        if (file && !study.judges) {
            throw UsageError(fmt::format("{} {}: must be with report stability, which judges", option, *file));
        }
        if (file && request.shard) {
            throw UsageError(fmt::format("{} {}: must be with report merge, not with --shard", option, *file));
        }
    }
    if (request.shard && request.exported) {
        throw UsageError(fmt::format("--export {}: must be without --shard", *request.exported));
    }
    if (request.shard && !study.pieces) {
        throw UsageError(fmt::format("--shard {}: must be with report error, stability or atlas", *request.shard));
    }
}

// Absent without --grid.
std::optional<reports::GridRequest> understand_grid(const Request& request) {
    const GridWords& words = request.grid;
    for (const auto& [option, given] :
         {std::pair{"--x", words.x.has_value()}, std::pair{"--y", words.y.has_value()},
          std::pair{"--measure", words.measure.has_value()}, std::pair{"--set", !words.set.empty()},
          std::pair{"--replays", !words.replays.empty()}}) {
        if (given && !words.scene) throw UsageError(fmt::format("{}: must be with --grid SCENE", option));
    }
    if (!words.scene) return std::nullopt;
    if (request.reports.front() != "atlas") {
        throw UsageError(fmt::format("--grid {}: must be with report atlas", *words.scene));
    }
    if (!words.x || !words.y) {
        throw UsageError(
            fmt::format("--grid {}: must be with --x OPTION=VALUES and --y OPTION=VALUES", *words.scene));
    }
    if (!find_scene(*words.scene) && !words.scene->ends_with(".json")) {
        understand(*words.scene, {});  // says what scenes there are
    }
    if (request.quick || !request.parts.empty()) {
        throw UsageError(fmt::format("--grid {}: must be without --quick and --only", *words.scene));
    }
    return reports::GridRequest{.scene = *words.scene,
                                .x = *words.x,
                                .y = *words.y,
                                .measure = words.measure.value_or("max_penetration_m"),
                                .set = words.set,
                                .replays = words.replays};
}

std::optional<Shard> understand_shard(const Request& request) {
    if (!request.shard) return std::nullopt;
    const auto shard = parse_shard(*request.shard);
    if (shard) return shard;
    throw UsageError(fmt::format("--shard {}: must be K/N with 1 <= K <= N <= 1000000", *request.shard));
}

const reports::Study& find_study(const std::vector<reports::Study>& all, const Request& request) {
    std::vector<std::string> names;
    for (const reports::Study& study : all) names.push_back(study.name);
    if (request.reports.size() != 1) {
        throw UsageError(
            fmt::format("report {}: must be one of {}", fmt::join(request.reports, " "), fmt::join(names, ", ")));
    }
    require_known("report", request.reports.front(), names);
    return *std::ranges::find(all, request.reports.front(), &reports::Study::name);
}

void make(const Request& request, const std::vector<std::filesystem::path>& merged) {
    const std::vector<reports::Study> all = reports::all_studies();
    const reports::Study& study = find_study(all, request);
    for (const std::string& part : request.parts) require_known("--only", part, study.parts);
    refuse_foreign(request, study);
    const auto shard = understand_shard(request);
    const std::filesystem::path folder = request.out.value_or("out/report-" + study.name);
    const auto count = make_study(
        study,
        {.folder = folder,
         .quick = request.quick,
         .problems = request.problems ? problem_files(*request.problems) : std::vector<std::filesystem::path>{},
         .beside = request.beside,
         .exported = request.exported,
         .parts = request.parts,
         .junit = request.junit,
         .markdown = request.markdown,
         .grid = understand_grid(request),
         .shard = shard,
         .jobs = request.report_jobs,
         .merged = merged,
         .note = note_text({.words = deciding_words(request), .shards = shard ? shard->count : 1})});
    if (shard) {
        fmt::print("shard {}: {} pieces, of which {} were there; in {}\n", to_text(*shard), count.all, count.there,
                   folder.string());
    } else {
        fmt::print("{}\n", (folder / "index.html").string());
    }
}

}  // namespace

void report(const Request& request) {
    if (request.reports.empty() || request.reports.front() != "merge") {
        make(request, {});
        return;
    }
    const Merge merge = understand_merge(request);
    try {
        make(merge.request, merge.folders);
    } catch (const reports::MissingPieces& missing) {
        print_missing(merge, missing.keys);
        throw;
    }
}

}  // namespace pushfactor::demos::commands
