// One run with everything that was asked to watch it: measurements, and the CSV files that were named.
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
    // With `timing` the run takes one thread, whose CPU time is a column of the CSV file. `folder` gets the last
    // good state when the run leaves the finite numbers.
    ObservedRun(const Choices& choices, const RunFiles& files, bool timing, std::filesystem::path folder);

    const Simulation& simulation() const { return simulation_; }

    // One step. When it leaves the finite numbers the state before it is written as a scene file that fails in its
    // first step, and NonFiniteError also says where.
    void advance();

    // Completes the files and gives the summary.
    std::string finish();

    // For a run that is stopped before its end: the CSV files get their names with what they hold so far. Gives a
    // line for each that says so; the names of those that cannot be written with the reason. Throws nothing.
    std::string keep_records();

    // What has to be said about what was not solved, in lines of their own; nothing when all is well. `panel` tells
    // runs of one scene apart.
    std::string warnings(const std::string& panel = "") const;

  private:
    std::string save_last_good() const;

    Choices choices_;
    Simulation simulation_;
    Measurements measurements_;
    std::vector<std::unique_ptr<Record>> records_;
    std::filesystem::path folder_;
    std::optional<std::string> save_state_;
    long last_recorded_ = 0;  // step; the one that leaves the finite numbers is not recorded
};

}  // namespace pushfactor::demos
