#include "demos/reports/stability/trial.h"

#include "demos/platform/output_file.h"
#include "demos/reports/stability/measures/measures.h"
#include "demos/scenes/scene_file.h"
#include "demos/text/errors.h"
#include "demos/text/json_file.h"

#include <algorithm>

namespace pushfactor::demos::reports::stability {

namespace {

namespace fs = std::filesystem;

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
      runs_(folder / "runs"),
      scene_(one.own() ? scene_file(one, folder).string() : std::get<std::string>(one.scene)),
      options_{{"preset", expected.preset}},
      start_(one.own() ? *one.own() : run_of(scene_, one.options).description) {
    options_.insert(options_.end(), one.options.begin(), one.options.end());
    command_ = command_text("run", scene_, options_);
    for (const Check& check : one.checks) {
        const std::string output = output_for(check.measure);
        if (!output.empty() && std::find(outputs_.begin(), outputs_.end(), output) == outputs_.end())
            outputs_.push_back(output);
    }
    for (const std::string& output : outputs_) command_ += " --" + output + " " + output + ".csv";
}

void Trial::start(const fs::path& program) {
    std::vector<std::string> words{"run", scene_};
    for (const auto& [name, text] : options_) words.insert(words.end(), {"--" + name, text});
    words.insert(words.end(), {"--summary", file(".json"), "--save-state", state(), "--replay", file(".html"),
                               "--replay-data", "poses"});
    for (const std::string& output : outputs_)
        words.insert(words.end(), {"--" + output, file("." + output + ".csv")});
    tool_ = std::make_unique<ChildProcess>(program.string(), "pushfactor", words);
}

fs::path Trial::state() const {
    return file("-state.json");
}

Verdict Trial::judge(const Check& check, std::size_t index, const std::vector<double>& values) const {
    const auto& [preset, outcome, reached] = expected_;
    Verdict verdict{.check = &check, .value = worst(check, values), .met = false, .holds = false};
    if (verdict.value) {
        verdict.met = better_or_equal(*verdict.value, check.bar, check.at_least);
        verdict.holds = verdict.met || (index < reached.size() && reached[index] &&
                                        better_or_equal(*verdict.value, *reached[index], check.at_least));
    }
    // Where an unwanted outcome is expected, bars are not judged unless `reached` is given.
    if (outcome != one_.wanted && reached.empty()) verdict.holds = true;
    return verdict;
}

void Trial::judge() {
    const Ending ending = tool_->ending();
    tool_.reset();
    Evidence evidence{.scene = &start_};
    if (ending.status == done) {
        evidence.summary = read_json_file(file(".json"), "summary");
        outcome_ = evidence.summary.at("outcome").get<std::string>();
        for (const std::string& output : outputs_)
            evidence.outputs[output] = read_columns(file("." + output + ".csv"));
    } else {
        outcome_ = ending.status == not_finite ? "non-finite" : "failed: " + ending.words;
    }
    for (std::size_t i = 0; i < one_.checks.size(); ++i) {
        const bool measured = ending.status == done;
        verdicts_.push_back(
            judge(one_.checks[i], i, measured ? take(one_.checks[i].measure, evidence) : std::vector<double>{}));
    }
    if (verdicts_.empty()) verdicts_.push_back({});
    for (Verdict& verdict : verdicts_) {
        verdict.holds = verdict.holds && (outcome_ == expected_.outcome || outcome_ == one_.wanted);
    }
    for (const std::string& output : outputs_) fs::remove(file("." + output + ".csv"));
}

bool Trial::holds() const {
    return std::all_of(verdicts_.begin(), verdicts_.end(), [](const Verdict& verdict) { return verdict.holds; });
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
