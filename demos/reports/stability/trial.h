// A trial: one case under one preset, run in a separate process so that cases cannot affect each other, and its
// verdicts; and the measures by which it is judged, computed from the output files of the run.
#pragma once

#include "demos/base/platform/progress.h"
#include "demos/base/text/json.h"
#include "demos/reports/stability/cases.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos::reports::stability {

// A CSV file of numbers, by column; other text is NaN.
using Columns = std::map<std::string, std::vector<double>, std::less<>>;

// Output of one run.
struct Evidence {
    const SceneDescription* scene = nullptr;
    Json summary{};
    std::map<std::string, Columns> outputs{};  // by option: "csv", "trajectory", "rows"
};

// The measured value, or one per body; empty if the run does not have it.
std::vector<double> take(const std::string& measure, const Evidence& evidence);

// The option whose file the measure is computed from; empty if the summary is enough.
std::string_view output_of(const std::string& measure);

struct Verdict {
    const Check* check = nullptr;   // null if only the outcome is checked
    std::optional<double> value{};  // the worst of several bodies
    std::optional<double> known{};  // known to be reached, instead of the bar
    bool met = true;                // the bar is met
    bool holds = true;              // as expected, or better
};

class Trial {
  public:
    // `one` and `expected` must outlive the trial. Its scene file, if it has one, is in `folder`/scenes; the output
    // of the run is in `folder`/runs.
    Trial(const Case& one, const Expected& expected, const std::filesystem::path& folder);

    const Case& one() const { return one_; }
    const Expected& expected() const { return expected_; }
    std::string name() const { return one_.name + "-" + expected_.preset; }
    const std::string& command() const { return command_; }  // that reproduces it

    // Names everything that decides the result.
    std::string key() const;

    // Runs it: outcome, measured values and the files of the run. `program` is the path of this program. Throws
    // ChildProcessError.
    Json run(const std::filesystem::path& program, const StopCheck& check) const;

    // Judges what run() returned, here or elsewhere, and writes its files.
    void judge(const Json& result);

    // Valid after judge().
    const std::string& outcome() const { return outcome_; }
    const std::vector<Verdict>& verdicts() const { return verdicts_; }  // at least one
    bool holds() const { return std::ranges::all_of(verdicts_, &Verdict::holds); }

    const SceneDescription& start() const { return start_; }

    // In the folder; missing if the run did not start.
    std::string replay() const { return "runs/" + name() + ".html"; }

    // Scene file of the last state; missing if the run failed.
    std::filesystem::path state() const { return file("-state.json"); }

  private:
    // Of the run, relative to the folder and in it.
    std::string name_of(const std::string& what) const { return "runs/" + name() + what; }
    std::filesystem::path file(const std::string& what) const { return folder_ / name_of(what); }
    Json measured(bool ended) const;

    const Case& one_;
    const Expected& expected_;
    std::filesystem::path folder_;
    std::string scene_;
    OptionTexts options_;
    SceneDescription start_;
    std::vector<std::string> outputs_;  // output options that the measures need
    std::string command_;
    std::string outcome_;
    std::vector<Verdict> verdicts_;
};

// Writes the scene files of the cases with a scene of their own.
void write_scenes(const std::vector<Chapter>& chapters, const std::filesystem::path& folder);

}  // namespace pushfactor::demos::reports::stability
