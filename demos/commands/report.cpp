#include "demos/commands/commands.h"
#include "demos/errors.h"
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

}  // namespace

void report(const Request& request) {
    if (request.reports.size() != 1) {
        throw UsageError(fmt::format("report {}: must be one of error", fmt::join(request.reports, " ")));
    }
    require_known("report", request.reports.front(), {"error"});
    for (const std::string& part : request.parts) require_known("--only", part, reports::error_parts());
    const std::filesystem::path folder = request.out.value_or("out/report-error");
    reports::report_error(
        {.folder = folder, .quick = request.quick, .problems = request.problems, .parts = request.parts});
    fmt::print("{}\n", (folder / "index.html").string());
}

}  // namespace pushfactor::demos::commands
