#include "demos/commands/commands.h"
#include "demos/errors.h"
#include "demos/reports/error_report.h"
#include "demos/reports/stability_report.h"
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

void print_page(const std::filesystem::path& folder) {
    fmt::print("{}\n", (folder / "index.html").string());
}

void make_error_report(const Request& request, const std::filesystem::path& folder) {
    for (const std::string& part : request.parts) require_known("--only", part, reports::error_parts());
    reports::report_error(
        {.folder = folder, .quick = request.quick, .problems = request.problems, .parts = request.parts});
    print_page(folder);
}

void make_stability_report(const Request& request, const std::filesystem::path& folder) {
    for (const std::string& part : request.parts) require_known("--only", part, reports::stability_parts());
    if (request.problems) throw UsageError("--problems: belongs to the report error");
    reports::report_stability({.folder = folder, .quick = request.quick, .parts = request.parts});
    print_page(folder);
}

}  // namespace

void report(const Request& request) {
    const std::vector<std::string> known{"error", "stability"};
    if (request.reports.size() != 1) {
        throw UsageError(
            fmt::format("report {}: must be one of {}", fmt::join(request.reports, " "), fmt::join(known, ", ")));
    }
    const std::string& name = request.reports.front();
    require_known("report", name, known);
    const std::filesystem::path folder = request.out.value_or("out/report-" + name);
    name == "error" ? make_error_report(request, folder) : make_stability_report(request, folder);
}

}  // namespace pushfactor::demos::commands
