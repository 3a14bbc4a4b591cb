// A run with its measurements and CSV files.
#pragma once

#include "demos/options/choices.h"
#include "demos/runs/measurements.h"
#include "demos/runs/records.h"
#include "demos/runs/run_files.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos {

class ObservedRun {
  public:
    // With `timing` the run uses one thread, whose CPU time is a column of the CSV file. `folder` receives the last
    // good state if the run becomes non-finite.
    ObservedRun(const Choices& choices, const RunFiles& files, bool timing, std::filesystem::path folder);

    const Simulation& simulation() const { return simulation_; }

    // Adds a file that is written step by step, like the CSV files. Only before the first step.
    void add(std::unique_ptr<Record> record) { records_.push_back(std::move(record)); }

    // Takes one step. If it becomes non-finite, the state before it is written as a scene file that fails in its
    // first step, and the message of NonFiniteError names the file.
    void advance();

    // Completes the files and returns the summary.
    std::string finish();

    // Completes the files of a run that stopped early, with the steps so far. Returns a note per file, or the
    // reason why it could not be written. Throws nothing.
    std::string keep_records();

    // Warnings, one per line; empty if there are none. `panel` distinguishes runs of one scene.
    std::string warnings(const std::string& panel = "") const;

  private:
    std::string save_last_good() const;

    Choices choices_;
    Simulation simulation_;
    Measurements measurements_;
    std::vector<std::unique_ptr<Record>> records_;
    std::filesystem::path folder_;
    std::optional<std::string> save_state_;
    long last_recorded_ = 0;  // step; a non-finite one is not recorded
};

}  // namespace pushfactor::demos
