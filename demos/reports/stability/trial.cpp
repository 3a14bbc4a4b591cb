#include "demos/base/platform/child_process.h"
#include "demos/base/platform/output_file.h"
#include "demos/base/text/csv.h"
#include "demos/base/text/json_reader.h"
#include "demos/base/text/numbers.h"
#include "demos/reports/stability/stability.h"
#include "demos/scenes/scene_file.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <thread>

namespace pushfactor::demos::reports::stability {

namespace {

namespace fs = std::filesystem;

Columns read_columns(const fs::path& file) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    std::vector<std::vector<double>*> columns;
    Columns result;
    for (const std::string& name : csv_cells(line)) columns.push_back(&result[name]);
    while (std::getline(stream, line)) {
        const std::vector<std::string> cells = csv_cells(line);
        for (std::size_t i = 0; i < columns.size(); ++i)
            columns[i]->push_back(parse_number(cells.at(i)).value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    return result;
}

fs::path scene_file(const Case& one, const fs::path& folder) {
    return folder / "scenes" / (one.name + ".json");
}

bool better_or_equal(double value, double bar, bool at_least) {
    return at_least ? value >= bar : value <= bar;
}

// The value that is farthest from meeting the check.
std::optional<double> worst(const Check& check, const std::vector<double>& values) {
    std::optional<double> found;
    for (const double value : values) {
        const double judged = std::abs(value - check.target) / check.scale;
        if (!found || !better_or_equal(judged, *found, check.at_least)) found = judged;
    }
    return found;
}

}  // namespace

Trial::Trial(const Case& one, const Expected& expected, const fs::path& folder)
    : one_(one),
      expected_(expected),
      folder_(folder),
      scene_(one.own() ? scene_file(one, folder).string() : std::get<std::string>(one.scene)),
      options_{{"preset", expected.preset}},
      start_(one.own() ? *one.own() : run_of(scene_, one.options).description) {
    options_.insert(options_.end(), one.options.begin(), one.options.end());
    options_ = awake(std::move(options_));
    command_ = command_text("run", scene_, options_);
    for (const Check& check : one.checks) {
        const std::string output(output_of(check.measure));
        if (!output.empty() && std::ranges::find(outputs_, output) == outputs_.end()) outputs_.push_back(output);
    }
    for (const std::string& output : outputs_) command_ += " --" + output + " " + output + ".csv";
}

std::string Trial::key() const {
    // The report's own scenes by their content, as people may keep an old folder.
    const std::string scene =
        one_.own() ? fmt::format("{} {:016x}", one_.name, text_hash(scene_file_text(*one_.own()))) : scene_;
    return fmt::format("stability: {}: {}", name(), command_text("run", scene, options_));
}

// In the folder, with relative names, so that the files of a run are the same on every machine.
Json Trial::run(const fs::path& program, const StopCheck& check) const {
    std::vector<std::string> words{"run", one_.own() ? "scenes/" + one_.name + ".json" : scene_};
    for (const auto& [name, text] : options_) words.insert(words.end(), {"--" + name, text});
    const std::array kept{name_of(".json"), name_of("-state.json"), name_of(".html")};
    words.insert(words.end(),
                 {"--summary", kept[0], "--save-state", kept[1], "--replay", kept[2], "--replay-data", "poses"});
    for (const std::string& output : outputs_)
        words.insert(words.end(), {"--" + output, name_of("." + output + ".csv")});
    std::error_code ignored;
    for (const std::string& name : kept) {
        if (fs::is_regular_file(folder_ / name, ignored)) fs::remove(folder_ / name, ignored);
    }
    ChildProcess tool(program.string(), "pushfactor", words, folder_);
    while (!tool.has_ended()) {
        check();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    const Ending ending = tool.ending();
    Json result{{"outcome", "non-finite"}, {"values", Json::array()}, {"files", Json::object()}};
    Evidence evidence{.scene = &start_};
    if (ending.status == done) {
        evidence.summary = read_json_file(file(".json"), "summary");
        result["outcome"] = evidence.summary.at("outcome");
        for (const std::string& output : outputs_)
            evidence.outputs[output] = read_columns(file("." + output + ".csv"));
    } else if (ending.status != not_finite) {
        result["outcome"] = "failed: " + ending.words;
        result["failed"] = ending.words;
    }
    for (const Check& check : one_.checks) {
        const bool ended = ending.status == done;
        result["values"].push_back(json_numbers(ended ? take(check.measure, evidence) : std::vector<double>{}));
    }
    for (const std::string& name : kept) {
        if (const auto text = read_bytes_of(folder_ / name)) result["files"][name] = *text;
    }
    for (const std::string& output : outputs_) fs::remove(file("." + output + ".csv"));
    return result;
}

void Trial::judge(const Json& result) {
    const auto& [preset, outcome, reached] = expected_;
    outcome_ = result.at("outcome").get<std::string>();
    const bool is_known = outcome_ == outcome || outcome_ == one_.wanted;
    // Where an unwanted outcome is expected, bars are not judged unless `reached` is given.
    const bool bars_count = outcome == one_.wanted || !reached.empty();
    for (std::size_t i = 0; i < one_.checks.size(); ++i) {
        const Check& check = one_.checks[i];
        Verdict& verdict = verdicts_.emplace_back(
            Verdict{.check = &check, .value = worst(check, numbers_in(result.at("values").at(i)))});
        if (i < reached.size()) verdict.known = reached[i];
        const auto meets = [&](const std::optional<double>& bar) {
            return verdict.value && bar && better_or_equal(*verdict.value, *bar, check.at_least);
        };
        verdict.met = meets(check.bar);
        verdict.holds = is_known && (!bars_count || verdict.met || meets(verdict.known));
    }
    if (verdicts_.empty()) verdicts_.push_back({.holds = is_known});
    for (const auto& [name, text] : result.at("files").items()) {
        write_file(folder_ / name, text.get_ref<const std::string&>());
    }
}

void write_scenes(const std::vector<Chapter>& chapters, const fs::path& folder) {
    make_folder(folder / "scenes");
    make_folder(folder / "runs");
    for (const Chapter& chapter : chapters) {
        for (const Case& one : chapter.cases) {
            if (one.own()) write_file(scene_file(one, folder), scene_file_text(*one.own()));
        }
    }
}

}  // namespace pushfactor::demos::reports::stability
