#include "demos/commands/commands.h"
#include "demos/figures/figure.h"
#include "demos/pages/figure_output.h"
#include "demos/pages/printing/latex.h"
#include "demos/platform/output_file.h"
#include "demos/platform/progress.h"
#include "demos/text/errors.h"
#include "demos/text/lengths.h"
#include "demos/text/numbers.h"
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

// One of two words for an option.
bool is_second(const char* option, const std::string& value, const char* first, const char* second) {
    if (value != first && value != second)
        throw UsageError(fmt::format("{} {}: must be {} or {}", option, value, first, second));
    return value == second;
}

int pixels_of(const std::string& option, int pixels) {
    if (pixels < 400 || pixels > 4096)
        throw UsageError(fmt::format("{}: {} pixels, must be 400 to 4096", option, pixels));
    return pixels;
}

FigureFormat format_of(const Request& request) {
    FigureFormat format{.samples = request.figure_samples};
    if (is_second("--theme", request.figure_theme, "light", "dark")) format.theme = Theme::dark;
    if (is_second("--background", request.figure_background, "plain", "none")) format.background = Background::none;
    const std::string option = "--width " + request.figure_width;
    const auto width = parse_length_mm(request.figure_width);
    if (!width) {
        const auto pixels = parse_integer(request.figure_width);
        if (!pixels) {
            throw UsageError(option + ": must be a number of pixels or a length on paper with mm, cm, in or pt");
        }
        if (request.figure_dpi || request.figure_letters) {
            throw UsageError(
                fmt::format("{}: must be a length on paper, say 85mm, with --dpi and --font-size", option));
        }
        format.width = pixels_of(option, *pixels);
        return format;
    }
    Print print{.width_mm = *width, .dpi = request.figure_dpi.value_or(300)};
    if (request.figure_letters) {
        const auto size = parse_length_mm(*request.figure_letters);
        print.letters_pt = size.value_or(0.0) / 25.4 * 72.0;
        if (!(print.letters_pt >= 4.0 && print.letters_pt <= 24.0)) {
            throw UsageError(
                fmt::format("--font-size {}: must be a length of 4pt to 24pt, say 8pt", *request.figure_letters));
        }
    }
    format.width = pixels_of(fmt::format("{} at {} dpi", option, print.dpi), print.pixels());
    format.print = print;
    return format;
}

// What a document takes in, where there is a PDF.
void write_latex(const Section& section, const Print& print, const std::filesystem::path& folder) {
    for (const std::string& file : section.plate.files) {
        if (!file.ends_with(".pdf")) continue;
        write_file(folder / (section.name + ".tex"),
                   latex_figure(section.name, file, print, section.plate.caption));
    }
}

}  // namespace

void figures(const Request& request) {
    const std::vector<figures::Figure> chosen = wanted(request.figures);
    const FigureFormat format = format_of(request);
    const std::filesystem::path folder = request.out.value_or("out/figures");
    make_folder(folder);
    figures::FigureOutput output(folder, format);
    std::vector<Section> sections;
    ProgressBar bar("figures", static_cast<long>(chosen.size()));
    for (const figures::Figure& figure : chosen) {
        stop_if_interrupted(
            fmt::format("{} of {} figures are in {}", sections.size(), chosen.size(), folder.string()));
        sections.push_back({std::string(figure.name), std::string(figure.title), figure.make(output, figure)});
        if (format.print) write_latex(sections.back(), *format.print, folder);
        bar.show(static_cast<long>(sections.size()));
    }
    if (format.print) write_file(folder / "pushfactor.bib", bibliography());
    write_file(folder / "index.html",
               page_text("Pushfactor: figures",
                         "Figures 5 to 11 of Tamis & Maggiore, Constraint based physics solver (2015), and some of "
                         "our own. All numbers were measured in the runs that are shown.",
                         sections));
    fmt::print("{}\n", (folder / "index.html").string());
}

}  // namespace pushfactor::demos::commands
