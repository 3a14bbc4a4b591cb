// The report on stability: the stress list, run and judged.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pushfactor::demos::reports {

struct StabilityRequest {
    std::filesystem::path folder;
    bool quick = false;              // the short cases
    std::vector<std::string> parts;  // names of stability_parts(); all when empty
};

// The chapters of the stress list.
std::vector<std::string> stability_parts();

// Writes stability.csv (one line a case, preset and check), thumbnails, index.html, the scenes that are not in the
// catalogue, and of each run its summary and last state. Files are whole after each chapter. Throws what errors.h
// names; CheckError when all was written but something was not as expected.
void report_stability(const StabilityRequest& request);

}  // namespace pushfactor::demos::reports
