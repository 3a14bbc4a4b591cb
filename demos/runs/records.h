// The CSV files of a run, one class a file. Units stand in the column names.
#pragma once

#include "demos/platform/output_file.h"
#include "demos/runs/simulation.h"

#include <memory>

namespace pushfactor::demos {

class Record {
  public:
    virtual ~Record() = default;
    virtual void observe(const Simulation& simulation) = 0;  // after each step
    virtual void finish() = 0;                               // gives the file its name; whole lines so far
    virtual std::string file_name() const = 0;
};

// One line a step. `step_us` only when `timing`, so that equal runs give equal files.
std::unique_ptr<Record> steps_record(const std::filesystem::path& path, bool timing);

// One line a movable body and `every` steps, the start included; velocities from the stored momenta.
std::unique_ptr<Record> trajectory_record(const std::filesystem::path& path, long every, const Simulation& start);

// One line a row and step: of the last engine step when there are substeps.
std::unique_ptr<Record> rows_record(const std::filesystem::path& path);

}  // namespace pushfactor::demos
