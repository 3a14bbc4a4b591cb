// Files that grow with a run, and those that are CSV, with units in the column names.
#pragma once

#include "demos/base/platform/output_file.h"
#include "demos/runs/simulation.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace pushfactor::demos {

// Completes a file with what there is so far, `until` where; returns a note, or the reason why it could not be
// written.
std::string kept(const std::string& file, const std::string& until, const std::function<void()>& finish);

class Record {
  public:
    virtual ~Record() = default;
    virtual void observe(const Simulation& simulation) = 0;  // after each step
    virtual void finish() = 0;                               // completes the file with the steps so far
    virtual std::string file_name() const = 0;
};

std::string_view name_of(engine::RowKind kind);

// One line per step. The column `step_us` only with `timing`, so that equal runs give equal files.
std::unique_ptr<Record> steps_record(const std::filesystem::path& path, bool timing);

// One line per movable body and `every` steps, the start included; velocities from the stored momenta.
std::unique_ptr<Record> trajectory_record(const std::filesystem::path& path, long every, std::uint32_t hash,
                                          const Simulation& start);

// One line per row and step; with substeps those of the last engine step.
std::unique_ptr<Record> rows_record(const std::filesystem::path& path);

// One line per step and body with measured motion: its distance from that.
std::unique_ptr<Record> errors_record(const std::filesystem::path& path, const Simulation& start);

}  // namespace pushfactor::demos
