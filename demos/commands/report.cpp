#include "demos/commands/commands.h"
#include "demos/reports/study.h"
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

// The file, or all of a folder, by name.
std::vector<std::filesystem::path> problem_files(const std::filesystem::path& given) {
    if (!std::filesystem::is_directory(given)) return {given};
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(given)) {
        if (entry.path().extension() == ".hdf5") files.push_back(entry.path());
    }
    if (files.empty()) {
        throw UsageError(fmt::format("--problems {}: must have files that end in .hdf5", given.string()));
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

void report(const Request& request) {
    const std::vector<reports::Study> all = reports::all_studies();
    std::vector<std::string> names;
    for (const reports::Study& study : all) names.push_back(study.name);
    if (request.reports.size() != 1) {
        throw UsageError(
            fmt::format("report {}: must be one of {}", fmt::join(request.reports, " "), fmt::join(names, ", ")));
    }
    const std::string& name = request.reports.front();
    require_known("report", name, names);
    const auto study = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    for (const std::string& part : request.parts) require_known("--only", part, study->parts);
    for (const auto& [option, value] :
         {std::pair{"--problems", request.problems}, std::pair{"--beside", request.beside},
          std::pair{"--export", request.exported}}) {
        if (value && name != "error") {
            throw UsageError(
                fmt::format("{} {}: must be with report error, the only one that has problems", option, *value));
        }
    }
    for (const auto& [option, file] :
         {std::pair{"--junit", request.junit}, std::pair{"--markdown", request.markdown}}) {
        if (file && !study->judges) {
            throw UsageError(fmt::format("{} {}: must be with report stability, which judges", option, *file));
        }
    }

    const std::filesystem::path folder = request.out.value_or("out/report-" + name);
    make_study(*study, {.folder = folder,
                        .quick = request.quick,
                        .problems = request.problems ? problem_files(*request.problems)
                                                     : std::vector<std::filesystem::path>{},
                        .beside = request.beside,
                        .exported = request.exported,
                        .parts = request.parts,
                        .junit = request.junit,
                        .markdown = request.markdown});
    fmt::print("{}\n", (folder / "index.html").string());
}

}  // namespace pushfactor::demos::commands
