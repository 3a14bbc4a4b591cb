#include "demos/commands/report.h"

#include "demos/base/platform/output_file.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/numbers.h"
#include "demos/base/text/suggest.h"
#include "demos/commands/commands.h"
#include "demos/reports/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pushfactor::demos::commands {

namespace {

// The command without what does not change results: that of the whole report.
std::vector<std::string> deciding_words(const Report& report) {
    const reports::StudyRequest& request = report.request;
    std::vector<std::string> words{"report", report.name};
    const auto add = [&words](const char* option, const std::string& value) {
        words.insert(words.end(), {option, value});
    };
    if (request.quick) words.emplace_back("--quick");
    if (!request.parts.empty()) add("--only", fmt::format("{}", fmt::join(request.parts, ",")));
    if (request.beside) add("--beside", request.beside->string());
    if (!request.grid) return words;
    const auto& [scene, x, y, measure, set, replays] = *request.grid;
    add("--grid", scene);
    add("--x", x);
    add("--y", y);
    if (measure) add("--measure", *measure);
    for (const std::string& text : set) add("--set", text);
    if (!replays.empty()) add("--replays", fmt::format("{}", fmt::join(replays, ",")));
    return words;
}

// A part has a folder of its own: its page and tables would replace those of the whole.
std::string folder_of(const Report& report) {
    const auto& parts = report.request.parts;
    const std::string part = report.request.grid ? "-grid"
                             : parts.empty()     ? ""
                                                 : fmt::format("-{}", fmt::join(parts, "-"));
    return report.out.value_or("out/report-" + report.name + part);
}

reports::Study find_study(const std::string& name) {
    const std::vector<reports::Study> all = reports::all_studies();
    const std::vector<std::string> names = names_of(all);
    if (name.empty()) throw UsageError("a report is missing: one of {}", fmt::join(names, ", "));
    require_known("report", name, names);
    return *std::ranges::find(all, name, &reports::Study::name);
}

}  // namespace

void make_report(const Report& report, const std::vector<std::filesystem::path>& merged) {
    const reports::Study study = find_study(report.name);
    reports::StudyRequest request = report.request;
    request.folder = folder_of(report);
    request.merged = merged;
    request.note = note_text({.words = deciding_words(report), .shards = request.shard ? request.shard->count : 1});
    require_own_endings(request.folder, request.junit, request.markdown);
    const auto& grid = request.grid;
    if (grid && !find_scene(grid->scene) && !grid->scene.ends_with(".json")) {
        understand(grid->scene, {});  // says what scenes there are
    }
    const auto count = make_study(study, request);
    if (request.shard) {
        print(fmt::format("shard {}: {} pieces, of which {} were there; in {}\n", to_text(*request.shard),
                          count.all, count.there, request.folder.string()));
    } else {
        print((request.folder / "index.html").string() + "\n");
    }
}

std::vector<Option> report_options() {
    const std::string pieces = "Shards of report error, stability and atlas, for report merge";
    const std::string grid = "A map of your own (report atlas)", group = "Options";
    return {
        {"out", "DIR",
         "folder for the page, its pictures and tables [out/report-NAME, and -PART or -grid for less than all]"},
        {"quick", "", "few values and short runs: under a minute"},
        {"only", "PART,...",
         "parts of the report. error: scenes, frozen, consistency; stability: its chapters; cost: scenes; "
         "atlas: maps; reality: its sections [all]",
         group, OptionKind::list},
        {"beside", "FILE",
         "error: results of other programs, as a CSV file with the columns of error.csv; reality: tosses of other "
         "engines, as tests/compare reality writes them",
         group, OptionKind::reads},
        {"export", "DIR", "error: write the frozen problems there as JSON, and more of contacts alone"},
        {"junit", "FILE", "the verdicts as JUnit XML", group, OptionKind::writes},
        {"markdown", "FILE", "a summary as Markdown, for $GITHUB_STEP_SUMMARY", group, OptionKind::writes},
        {"shard", "K/N", "make only the K-th of N shares, and no page; finished pieces are skipped", pieces},
        {"jobs", "N", "runs at once [one per processor; error, which measures times: 1]", pieces},
        {"grid", "SCENE", "name of a scene, or a scene file", grid},
        {"x", "OPTION=VALUES", "values FROM:TO:STEP, log:FROM:TO:COUNT (equal factors) or A,B,C", grid},
        {"y", "OPTION=VALUES", "the same for the other axis", grid},
        {"measure", "NAME", "number of the summary to show in the cells [max_penetration_m]", grid},
        {"set", "OPTION=VALUE", "option for all cells; may be repeated", grid, OptionKind::list},
        {"replays", "X:Y,...|all", "add replays of these cells, X:Y as in atlas.csv", grid, OptionKind::list},
    };
}

namespace {

// The parts of a list that may be repeated, too.
std::vector<std::string> take_list(Words& words, const char* option, bool has_effect, const char* must) {
    words.take(option, has_effect, must);
    std::vector<std::string> parts;
    for (const std::string& text : words.take_all(option)) {
        for (const std::string_view part : parts_of(text)) parts.emplace_back(part);
    }
    return parts;
}

AnyCommand read_any_report(Words& words) {
    const std::vector<std::string> names = words.take_names();
    if (!names.empty() && names.front() == "merge") return read_merge(words);
    if (names.size() > 1) throw UsageError("report {}: must be one report at a time", fmt::join(names, " "));
    return read_report(words, names.empty() ? "" : names.front());
}

}  // namespace

Report read_report(Words& words, const std::string& name) {
    const reports::Study study = find_study(name);
    Report command{.name = name, .out = words.take("out")};
    reports::StudyRequest& request = command.request;
    for (const char* const option : {"shard", "jobs"}) {
        words.take(option, study.pieces != nullptr, "with report error, stability or atlas");
    }
    request.shard = words.take_shard("shard");
    request.jobs = words.take_whole("jobs", 1, 1024);
    const bool page = !request.shard;
    const auto scene = words.take("grid", name == "atlas", "with report atlas");
    const bool grid = scene.has_value();
    constexpr const char* with_grid = "with --grid SCENE";
    const auto x = words.take("x", grid, with_grid), y = words.take("y", grid, with_grid),
               measure = words.take("measure", grid, with_grid);
    words.take("set", grid, with_grid);
    const auto set = words.take_all("set"), replays = take_list(words, "replays", grid, with_grid);
    if (grid && (!x || !y)) {
        throw UsageError("--grid {}: must be with --x OPTION=VALUES and --y OPTION=VALUES", *scene);
    }
    if (grid) request.grid = {*scene, *x, *y, measure, set, replays};
    request.quick = words.take("quick", !grid, "without --grid, which says all values").has_value();
    request.parts = take_list(words, "only", !grid, "without --grid, which is one map");
    if (!request.parts.empty()) {
        const std::vector<std::string> known = study.parts();
        for (const std::string& part : request.parts) require_known("--only", part, known);
    }
    const bool frozen = name == "error" && request.wants("frozen");
    const bool tosses = name == "reality" && request.wants("tosses");
    request.beside =
        words.take("beside", name == "error" || tosses, "with report error, or the tosses of report reality");
    words.take("export", page, "without --shard");
    request.exported = words.take("export", frozen, "with report error, the only one that has frozen problems");
    for (const auto& [option, value] :
         {std::pair{"junit", &request.junit}, std::pair{"markdown", &request.markdown}}) {
        words.take(option, study.judges, "with report stability, which judges");
        *value = words.take(option, page, "with report merge, not with --shard");
    }
    require_own_endings(folder_of(command), request.junit, request.markdown);
    words.refuse_rest("report " + name);
    return command;
}

void carry_out(const Report& command) {
    make_report(command, {});
}

const Entry report_entry{
    "report", "REPORT",
    "measurements of many runs, as CSV files and a page of plots. REPORT is `error`: error against work "
    "and run time, for every method and scene; `stability`: stiff and extreme cases, each judged; `cost`: "
    "work and time per step of each scene; `atlas`: maps of outcomes over two parameters; `reality`: "
    "tosses, dice, heaps as they were measured, and as they are computed; `merge DIR...`: the page of the "
    "shards in these folders",
    report_options, read_any_report};

}  // namespace pushfactor::demos::commands
