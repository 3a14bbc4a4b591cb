#include "demos/commands/commands.h"
#include "demos/errors.h"
#include "demos/reports/atlas_report.h"
#include "demos/reports/error_report.h"
#include "demos/suggest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pushfactor::demos::commands {

namespace {

void require_known(const char* what, const std::string& name, const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    throw UsageError(
        fmt::format("{} {}: must be one of {}{}", what, name, fmt::join(known, ", "), suggestion(name, known)));
}

void report_error(const Request& request, const std::filesystem::path& folder) {
    for (const std::string& part : request.parts) require_known("--only", part, reports::error_parts());
    reports::report_error(
        {.folder = folder, .quick = request.quick, .problems = request.problems, .parts = request.parts});
}

void report_atlas(const Request& request, const std::filesystem::path& folder) {
    for (const std::string& map : request.parts) require_known("--only", map, reports::atlas_map_names());
    if (request.problems)
        throw UsageError("--problems: must be given with report error, the only one that has them");
    reports::report_atlas({.folder = folder, .quick = request.quick, .maps = request.parts});
}

}  // namespace

void report(const Request& request) {
    const std::vector<std::string> names{"error", "atlas"};
    if (request.reports.size() != 1) {
        throw UsageError(
            fmt::format("report {}: must be one of {}", fmt::join(request.reports, " "), fmt::join(names, ", ")));
    }
    const std::string& name = request.reports.front();
    require_known("report", name, names);
    const std::filesystem::path folder = request.out.value_or("out/report-" + name);
    if (name == "error") {
        report_error(request, folder);
    } else {
        report_atlas(request, folder);
    }
    fmt::print("{}\n", (folder / "index.html").string());
}

}  // namespace pushfactor::demos::commands
