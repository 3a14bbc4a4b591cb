#include "demos/base/platform/output_file.h"
#include "demos/base/platform/progress.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/numbers.h"
#include "demos/base/text/suggest.h"
#include "demos/commands/commands.h"
#include "demos/figures/figure_output.h"
#include "demos/figures/printing/latex.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pushfactor::demos::commands {

namespace {

// The named figures, or all.
std::vector<figures::Figure> wanted(const std::vector<std::string>& named) {
    const std::vector<std::string> known = names_of(figures::all_figures());
    for (const std::string& name : named) require_known("figure", name, known);
    std::vector<figures::Figure> result;
    for (const figures::Figure& figure : figures::all_figures()) {
        if (named.empty() || std::ranges::find(named, figure.name) != named.end()) result.push_back(figure);
    }
    return result;
}

int pixels_of(const std::string& option, double pixels) {
    const double whole = std::round(pixels);
    if (whole < 400.0 || whole > 4096.0) throw UsageError("{}: {:.6g} pixels, must be 400 to 4096", option, whole);
    return static_cast<int>(whole);
}

FigureFormat format_of(const Figures& command) {
    FigureFormat format;
    if (command.samples) format.samples = *command.samples;
    if (command.theme == "dark") format.theme = Theme::dark;
    if (command.background == "none") format.background = Background::none;
    const std::string text = command.width.value_or("1600"), option = "--width " + text;
    const auto width = parse_length_mm(text);
    if (!width) {
        const auto pixels = parse_integer(text);
        if (!pixels) {
            throw UsageError(option + ": must be a number of pixels or a length on paper with mm, cm, in or pt");
        }
        format.width = pixels_of(option, *pixels);
        return format;
    }
    Print print{.width_mm = *width, .dpi = command.dpi.value_or(Print{}.dpi)};
    if (command.letters) {
        print.letters_pt = parse_length_mm(*command.letters).value_or(0.0) / 25.4 * 72.0;
        if (!(print.letters_pt >= 4.0 && print.letters_pt <= 24.0)) {
            throw UsageError("--font-size {}: must be a length of 4pt to 24pt, say 8pt", *command.letters);
        }
    }
    format.width = pixels_of(fmt::format("{} at {} dpi", option, print.dpi), print.inches() * print.dpi);
    format.print = print;
    return format;
}

// What a document takes in, where there is a PDF.
void write_latex(Section& section, const Print& print, const std::filesystem::path& folder) {
    const std::vector<std::string> files = section.content.files;
    for (const std::string& file : files) {
        if (!file.ends_with(".pdf")) continue;
        section.content.files.insert(section.content.files.end(), {section.name + ".tex", "pushfactor.bib"});
        write_file(folder / (section.name + ".tex"),
                   latex_figure(section.name, file, print, section.content.caption));
    }
}

// The page loses no figure that it had: those that were not made again are as they were.
std::vector<Section> with_others(const std::vector<Section>& made, const std::string& page) {
    std::vector<Section> all;
    for (const figures::Figure& figure : figures::all_figures()) {
        const std::string name(figure.name), before = section_on(page, name);
        const auto now = std::ranges::find(made, name, &Section::name);
        if (now != made.end()) {
            all.push_back(*now);
        } else if (!before.empty()) {
            all.push_back({name, std::string(figure.title), {.kept = before}});
        }
    }
    return all;
}

std::vector<Option> figures_options() {
    return {
        {"out", "DIR", "folder for the page and its pictures [out/figures]"},
        {"width", "N|LENGTH",
         "width of a figure in pixels, or for print a length (85mm, 17cm, 3.35in, 240pt), which adds NAME.pdf, "
         "NAME.tex and pushfactor.bib [1600]"},
        {"dpi", "N", "with a length: pixels per inch, 72 to 1200 and at most 4096 pixels in all [300]"},
        {"font-size", "LENGTH", "with a length: size of all letters on paper, 4 to 24 pt [8pt]"},
        {"theme", "NAME", "light, or dark for slides [light]"},
        {"background", "NAME", "plain, or none: transparent, without the ground and its shadows [plain]"},
        {"samples", "N",
         "renderings averaged per picture: smoother edges and soft shadows; from 16 on ambient occlusion too [32]"},
    };
}

std::string names_and_titles() {
    std::string text = "\nFigures:\n";
    for (const figures::Figure& figure : figures::all_figures()) {
        text += fmt::format("  {:<20} {}\n", figure.name, figure.title);
    }
    return text;
}

AnyCommand read_figures(Words& words) {
    Figures command;
    command.names = words.take_names();
    command.out = words.take("out");
    command.width = words.take("width");
    const bool on_paper = command.width && parse_length_mm(*command.width);
    const char* const must = "with a --width on paper, say 85mm";
    for (const char* const option : {"dpi", "font-size"}) words.take(option, on_paper, must);
    command.dpi = words.take_whole("dpi", 72, 1200);
    command.letters = words.take("font-size");
    command.theme = words.take_word("theme", {"light", "dark"});
    command.background = words.take_word("background", {"plain", "none"});
    command.samples = words.take_whole("samples", 1, 256);
    wanted(command.names);
    format_of(command);
    return command;
}

}  // namespace

void carry_out(const Figures& command) {
    const std::vector<figures::Figure> chosen = wanted(command.names);
    const FigureFormat format = format_of(command);
    const std::filesystem::path folder = command.out.value_or("out/figures");
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
    const std::string before = read_bytes_of(folder / "index.html").value_or("");
    write_index(
        folder,
        page_text("Pushfactor: figures",
                  "Figures 5 to 11 of Tamis & Maggiore, Constraint based physics solver (2015), and some of "
                  "our own. All numbers were measured in the runs that are shown.",
                  with_others(sections, before)));
    print((folder / "index.html").string() + "\n");
}

const Entry figures_entry{
    "figures",       "[FIGURE...]", "Figures 5 to 11 of the paper and some of our own, on one page",
    figures_options, read_figures,  names_and_titles};

}  // namespace pushfactor::demos::commands
