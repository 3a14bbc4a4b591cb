// A run beside the trajectory of an earlier one.
#pragma once

#include "demos/pictures/checks/verdict.h"
#include "demos/runs/records.h"
#include "demos/scenes/motions/pose_reader.h"

#include <filesystem>
#include <optional>
#include <string>

namespace pushfactor::demos::checks {

// Written to no file.
class TrajectoryCheck final : public Record {
  public:
    // `file` is that of `--trajectory`; it is read line by line. A pose may differ by `tolerance` [m], and [rad] in
    // orientation. Throws UsageError for a file that is not such a table.
    TrajectoryCheck(const std::filesystem::path& file, double tolerance);

    // Compares the lines of this instant, if there are any.
    void observe(const Simulation& simulation) override;
    void finish() override {}
    std::string file_name() const override { return ""; }

    // After the last step.
    RunVerdict verdict() const;

  private:
    void compare(const Simulation& simulation);

    double tolerance_;
    PoseReader reader_;
    std::optional<PoseLine> next_;
    long lines_ = 0, instants_ = 0;      // that were compared
    double last_ = 0.0, spacing_ = 0.0;  // s: the last of these instants, and the time before it
    double end_ = 0.0;                   // s, of the run
    long movable_ = 0;                   // bodies that have lines
    double largest_ = 0.0;               // m or rad
    std::string first_;                  // the first difference beyond the tolerance
};

}  // namespace pushfactor::demos::checks
