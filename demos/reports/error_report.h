// The report on error against run time: sweeps of whole runs, frozen problems, consistency, and a page of plots.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pushfactor::demos::reports {

struct ErrorRequest {
    std::filesystem::path folder;
    bool quick = false;              // few values and short runs
    bool problems = false;           // the frozen problems as JSON files too
    std::vector<std::string> parts;  // names of error_parts(); all when empty
};

// The scenes of the sweeps, "frozen" and "consistency".
std::vector<std::string> error_parts();

// Writes error.csv, frozen.csv, consistency.csv, about.json, plots and index.html. Files are whole after each part,
// so an interrupted report keeps what it had. Throws what errors.h names.
void report_error(const ErrorRequest& request);

}  // namespace pushfactor::demos::reports
