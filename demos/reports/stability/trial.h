// One case under one preset: a run of the program in a process of its own, so that nothing that a case does reaches
// another one, and what was expected of it.
#pragma once

#include "demos/platform/child_process.h"
#include "demos/reports/stability/cases.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::stability {

struct Verdict {
    const Check* check = nullptr;   // none where the outcome is all that is asked
    std::optional<double> value{};  // of several bodies the worst
    bool met = true;                // the bar
    bool holds = true;              // as expected, or better
};

class Trial {
  public:
    // `one` and `expected` must outlive the trial. Its scene file, if it has one, lies in `folder`/scenes; what the
    // run writes for the report lies in `folder`/runs.
    Trial(const Case& one, const Expected& expected, const std::filesystem::path& folder);

    const Case& one() const { return one_; }
    const Expected& expected() const { return expected_; }
    std::string name() const { return one_.name + "-" + expected_.preset; }
    const std::string& command() const { return command_; }  // that shows the same

    // `program` is this one. Throws ChildProcessError.
    void start(const std::filesystem::path& program);
    bool has_ended() const { return tool_->has_ended(); }
    void judge();  // after it has ended

    // After judge().
    const std::string& outcome() const { return outcome_; }
    const std::vector<Verdict>& verdicts() const { return verdicts_; }  // one at least
    bool holds() const;

    const SceneDescription& start() const { return start_; }

    // The last state, as a scene file. There is none where the run failed.
    std::filesystem::path state() const;

  private:
    std::filesystem::path file(const std::string& what) const { return runs_ / (name() + what); }
    Verdict judge(const Check& check, std::size_t index, const std::vector<double>& values) const;

    const Case& one_;
    const Expected& expected_;
    std::filesystem::path runs_;
    std::string scene_;
    OptionTexts options_;
    SceneDescription start_;
    std::vector<std::string> outputs_;  // options that write what is measured
    std::string command_;
    std::unique_ptr<ChildProcess> tool_;
    std::string outcome_;
    std::vector<Verdict> verdicts_;
};

// Writes the scene files of the cases that have one of their own.
void write_scenes(const std::vector<Chapter>& chapters, const std::filesystem::path& folder);

}  // namespace pushfactor::demos::reports::stability
