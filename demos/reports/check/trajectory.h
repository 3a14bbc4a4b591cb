// A run beside the trajectory of an earlier one.
#pragma once

#include "demos/reports/check/verdict.h"
#include "demos/runs/records.h"

#include <filesystem>
#include <fstream>
#include <string>

namespace pushfactor::demos::reports::check {

class TrajectoryCheck {
  public:
    // `file` is that of `--trajectory`; it is read line by line. A pose may differ by `tolerance` [m], and [rad] in
    // orientation. Throws UsageError for a file that is not such a table.
    TrajectoryCheck(const std::filesystem::path& file, double tolerance);

    // Compares the lines of this instant, if there are any.
    void observe(const Simulation& simulation);

    // After the last step.
    RunVerdict verdict() const;

  private:
    struct Line {
        double time = 0.0;  // s
        std::size_t body = 0;
        engine::Vector3 position = engine::Vector3::Zero();
        engine::Quaternion orientation = engine::Quaternion::Identity();
    };

    bool read_line();
    void compare(const Simulation& simulation);

    std::string name_;
    double tolerance_;
    std::ifstream stream_;
    Line next_;
    bool has_next_ = false;
    long lines_ = 1, compared_ = 0;
    double largest_ = 0.0;  // m or rad
    std::string first_;     // the first difference beyond the tolerance
};

}  // namespace pushfactor::demos::reports::check
