#include "demos/commands/commands.h"
#include "demos/figures/figure.h"
#include "demos/pages/figure_output.h"
#include "demos/platform/output_file.h"
#include "demos/platform/progress.h"
#include "demos/text/errors.h"
#include "demos/text/suggest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pushfactor::demos::commands {

namespace {

// The named figures, or all.
std::vector<figures::Figure> wanted(const std::vector<std::string>& named) {
    std::vector<std::string> known;
    for (const figures::Figure& figure : figures::all_figures()) known.emplace_back(figure.name);
    for (const std::string& name : named) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        throw UsageError(
            fmt::format("figure {}: must be one of {}{}", name, fmt::join(known, ", "), suggestion(name, known)));
    }
    std::vector<figures::Figure> result;
    for (const figures::Figure& figure : figures::all_figures()) {
        if (named.empty() || std::find(named.begin(), named.end(), figure.name) != named.end())
            result.push_back(figure);
    }
    return result;
}

}  // namespace

void figures(const Request& request) {
    const std::vector<figures::Figure> chosen = wanted(request.figures);
    const std::filesystem::path folder = request.out.value_or("out/figures");
    make_folder(folder);
    figures::FigureOutput output(folder, request.figure_width, request.figure_samples);
    std::vector<Section> sections;
    ProgressBar bar("figures", static_cast<long>(chosen.size()));
    for (const figures::Figure& figure : chosen) {
        stop_if_interrupted(
            fmt::format("{} of {} figures are in {}", sections.size(), chosen.size(), folder.string()));
        sections.push_back({std::string(figure.name), std::string(figure.title), figure.make(output, figure)});
        bar.show(static_cast<long>(sections.size()));
    }
    write_file(folder / "index.html",
               page_text("Pushfactor: figures",
                         "Figures 5 to 11 of Tamis & Maggiore, Constraint based physics solver (2015), and some of "
                         "our own. All numbers were measured in the runs that are shown.",
                         sections));
    fmt::print("{}\n", (folder / "index.html").string());
}

}  // namespace pushfactor::demos::commands
