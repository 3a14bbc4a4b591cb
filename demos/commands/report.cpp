#include "demos/commands/commands.h"
#include "demos/reports/atlas_report.h"
#include "demos/reports/cost_report.h"
#include "demos/reports/error_report.h"
#include "demos/reports/stability_report.h"
#include "demos/text/errors.h"
#include "demos/text/suggest.h"

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

struct Report {
    std::string name;
    std::vector<std::string> parts;
    void (*make)(const Request& request, const std::filesystem::path& folder);
};

std::vector<Report> all_reports() {
    return {
        {"error", reports::error_parts(),
         [](const Request& request, const std::filesystem::path& folder) {
             reports::report_error(
                 {.folder = folder, .quick = request.quick, .problems = request.problems, .parts = request.parts});
         }},
        {"stability", reports::stability_parts(),
         [](const Request& request, const std::filesystem::path& folder) {
             reports::report_stability({.folder = folder, .quick = request.quick, .parts = request.parts});
         }},
        {"cost", reports::cost_parts(),
         [](const Request& request, const std::filesystem::path& folder) {
             reports::report_cost({.folder = folder, .quick = request.quick, .parts = request.parts});
         }},
        {"atlas", reports::atlas_map_names(), [](const Request& request, const std::filesystem::path& folder) {
             reports::report_atlas({.folder = folder, .quick = request.quick, .maps = request.parts});
         }}};
}

}  // namespace

void report(const Request& request) {
    const std::vector<Report> all = all_reports();
    std::vector<std::string> names;
    for (const Report& report : all) names.push_back(report.name);
    if (request.reports.size() != 1) {
        throw UsageError(
            fmt::format("report {}: must be one of {}", fmt::join(request.reports, " "), fmt::join(names, ", ")));
    }
    const std::string& name = request.reports.front();
    require_known("report", name, names);
    const Report& report =
        *std::find_if(all.begin(), all.end(), [&](const Report& candidate) { return candidate.name == name; });
    for (const std::string& part : request.parts) require_known("--only", part, report.parts);
    if (request.problems && name != "error")
        throw UsageError("--problems: must be given with report error, the only one that has them");

    const std::filesystem::path folder = request.out.value_or("out/report-" + name);
    report.make(request, folder);
    fmt::print("{}\n", (folder / "index.html").string());
}

}  // namespace pushfactor::demos::commands
