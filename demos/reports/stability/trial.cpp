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

bool brings_scene(const Case& one) {
    return one.own || one.text;
}

fs::path scene_file(const Case& one, const fs::path& folder) {
    return folder / "scenes" / (one.name + ".json");
}

bool better_or_equal(double value, double bar, bool at_least) {
    return at_least ? value >= bar : value <= bar;
}

// What is farthest from what the check asks for.
std::optional<double> worst(const Check& check, const std::vector<double>& values) {
    std::optional<double> found;
    for (const double value : values) {
        const double judged = std::abs(value - check.target) / check.scale;
        if (!found || !better_or_equal(judged, *found, check.at_least)) found = judged;
    }
    return found;
}

SceneDescription description_of(const Case& one) {
    if (one.wanted == "refused") return {};
    return one.own ? *one.own : run_of(one.scene, one.options).description;
}

}  // namespace

Trial::Trial(const Case& one, const Expected& expected, const fs::path& folder)
    : one_(one),
      expected_(expected),
      runs_(folder / "runs"),
      scene_(brings_scene(one) ? scene_file(one, folder).string() : one.scene),
      start_(description_of(one)) {
    OptionTexts options{{"preset", expected.preset}};
    options.insert(options.end(), one.options.begin(), one.options.end());
    command_ = command_text("run", scene_, options);
    for (const std::string& output : outputs()) command_ += " --" + output + " " + output + ".csv";
}

std::vector<std::string> Trial::outputs() const {
    std::vector<std::string> found;
    for (const Check& check : one_.checks) {
        const std::string output = output_for(check.measure);
        if (!output.empty() && std::find(found.begin(), found.end(), output) == found.end())
            found.push_back(output);
    }
    return found;
}

void Trial::start(const fs::path& program) {
    std::vector<std::string> words{"run", scene_, "--preset", expected_.preset};
    for (const auto& [name, text] : one_.options) words.insert(words.end(), {"--" + name, text});
    words.insert(words.end(), {"--summary", file(".json"), "--save-state", state()});
    for (const std::string& output : outputs())
        words.insert(words.end(), {"--" + output, file("." + output + ".csv")});
    tool_ = std::make_unique<ChildProcess>(program.string(), "pushfactor", words);
}

fs::path Trial::state() const {
    return file("-state.json");
}

void Trial::read_outcome(const Ending& ending) {
    switch (ending.status) {
        case done:
            outcome_ = read_json_file(file(".json"), "summary").at("outcome").get<std::string>();
            break;
        case bad_usage:
            outcome_ = ending.words.find(one_.field) != std::string::npos ? "refused" : "refused without its name";
            break;
        case not_finite:
            outcome_ = "non-finite";
            break;
        default:
            outcome_ = "failed: " + ending.words;
    }
}

Verdict Trial::judge(const Check& check, std::size_t index, const std::vector<double>& values) const {
    Verdict verdict{.check = &check, .value = worst(check, values), .met = false, .holds = false};
    if (verdict.value) {
        verdict.met = better_or_equal(*verdict.value, check.bar, check.at_least);
        verdict.holds = verdict.met;
        if (index < expected_.reached.size() && expected_.reached[index]) {
            verdict.holds =
                verdict.met || better_or_equal(*verdict.value, *expected_.reached[index], check.at_least);
        }
    }
    // Where another outcome than the wanted one is expected, the bars cannot be, unless it says what is reached.
    if (expected_.outcome != one_.wanted && expected_.reached.empty()) verdict.holds = true;
    return verdict;
}

void Trial::judge_checks() {
    Evidence evidence{.scene = &start_, .summary = read_json_file(file(".json"), "summary")};
    for (const std::string& output : outputs())
        evidence.outputs[output] = read_columns(file("." + output + ".csv"));
    for (std::size_t i = 0; i < one_.checks.size(); ++i) {
        verdicts_.push_back(judge(one_.checks[i], i, take(one_.checks[i].measure, evidence)));
    }
}

void Trial::judge() {
    const Ending ending = tool_->ending();
    tool_.reset();
    read_outcome(ending);
    if (ending.status == done) {
        judge_checks();
    } else {
        for (std::size_t i = 0; i < one_.checks.size(); ++i) verdicts_.push_back(judge(one_.checks[i], i, {}));
    }
    if (verdicts_.empty()) verdicts_.push_back({});
    for (Verdict& verdict : verdicts_) {
        verdict.holds = verdict.holds && (outcome_ == expected_.outcome || outcome_ == one_.wanted);
    }
    for (const std::string& output : outputs()) fs::remove(file("." + output + ".csv"));
}

bool Trial::holds() const {
    return std::all_of(verdicts_.begin(), verdicts_.end(), [](const Verdict& verdict) { return verdict.holds; });
}

void write_scenes(const std::vector<Chapter>& chapters, const fs::path& folder) {
    make_folder(folder / "scenes");
    make_folder(folder / "runs");
    for (const Chapter& chapter : chapters) {
        for (const Case& one : chapter.cases) {
            if (!brings_scene(one)) continue;
            write_file(scene_file(one, folder), one.text ? *one.text : scene_file_text(*one.own));
        }
    }
}

}  // namespace pushfactor::demos::reports::stability
