#include "demos/figures/plot.h"

#include "demos/base/platform/assets.h"
#include "demos/base/platform/child_process.h"
#include "demos/base/platform/output_file.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/numbers.h"
#include "demos/base/text/palette.h"
#include "renderer/images/png.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <sstream>

namespace pushfactor::demos {

namespace {

namespace fs = std::filesystem;

// A gnuplot string: in single quotes, where only the quote itself is special and is doubled.
std::string gnuplot_string(const std::string& text) {
    return (std::ostringstream() << std::quoted(text, '\'', '\'')).str();
}

// The palette of the frames, or that of print, as gnuplot variables.
std::string colours(const FigureFormat& format) {
    std::string text;
    for (const Colour& colour : format.print ? print_palette : palette) {
        text += fmt::format("{} = {}; ", colour.name, gnuplot_string(fmt::format("#{:06x}", number_of(colour))));
    }
    return text;
}

std::string variables_of(const Plot& plot) {
    std::string text;
    for (const auto& [name, value] : plot.variables) {
        const auto* number = std::get_if<double>(&value);
        text += fmt::format("{} = {}; ", name,
                            number ? to_text(*number) : gnuplot_string(std::get<std::string>(value)));
    }
    return text;
}

// The variables that style.gp uses.
std::string style_of(const Plot& plot, const std::string& file_format) {
    const FigureFormat& format = plot.format;
    const double letters = format.print ? format.print->letter_pixels() : plot.width / 75.0;
    const double pixels_an_inch = format.print ? format.print->dpi : 96.0;
    return fmt::format(
        "format = {}; width = {}; height = {}; letters = {}; inch = {}; dark = {}; transparent = {}; ",
        gnuplot_string(file_format), plot.width, static_cast<int>(plot.width / plot.aspect), letters,
        pixels_an_inch, format.theme == Theme::dark ? 1 : 0, format.background == Background::none ? 1 : 0);
}

// Cairo writes the time into a PDF; instead that of SOURCE_DATE_EPOCH, or 1970, so that equal figures are equal
// files.
void set_date(std::string& pdf) {
    const char* const epoch = std::getenv("SOURCE_DATE_EPOCH");
    const auto seconds = epoch ? parse_integer(epoch) : std::nullopt;
    const std::string date =
        fmt::format("(D:{:%Y%m%d%H%M%S}", fmt::gmtime(static_cast<std::time_t>(seconds.value_or(0))));
    for (const char* const key : {"/CreationDate ", "/ModDate "}) {
        const std::size_t at = pdf.find(key + std::string("(D:"));
        if (at != std::string::npos) pdf.replace(at + std::string_view(key).size(), date.size(), date);
    }
}

// Returns the name of the file.
std::string draw(const Plot& plot, const std::string& file_format, const fs::path& folder) {
    const fs::path scripts = asset_folder("plots");
    const std::string made = plot.name + "." + file_format;
    // Gnuplot opens the file itself; it appears whole, below its name.
    const StagedFile staged(folder / made, "." + file_format);
    const std::string settings =
        fmt::format("{}{}{}data = {}; made = {}; style = {}", colours(plot.format), variables_of(plot),
                    style_of(plot, file_format), gnuplot_string((folder / plot.data).string()),
                    gnuplot_string(staged.path().string()), gnuplot_string((scripts / "style.gp").string()));
    try {
        ChildProcess("gnuplot", "gnuplot-nox", {"-e", settings, (scripts / (plot.script + ".gp")).string()})
            .finish();
    } catch (const ChildProcessError& error) {
        throw OutputError(error.what());
    }
    std::string bytes = read_bytes_of(staged.path()).value_or("");
    if (file_format == "pdf") set_date(bytes);
    if (file_format == "png" && plot.format.print) {
        const auto png =
            renderer::with_notes({bytes.begin(), bytes.end()},
                                 {.dots_per_inch = static_cast<double>(plot.format.print->dpi), .film = {}});
        bytes.assign(png.begin(), png.end());
    }
    write_file(folder / made, bytes);
    return made;
}

const char* const what_plots_need =
    " The plot needs gnuplot, which is not installed (Debian: apt install gnuplot-nox); its data are here.";

}  // namespace

void add_plot(const Plot& plot, const std::string& text, const fs::path& folder, SectionContent& content) {
    write_file(folder / plot.data, text);
    content.files.push_back(plot.data);
    if (!find_program("gnuplot")) {
        if (!content.caption.ends_with(what_plots_need)) content.caption += what_plots_need;
        return;
    }
    content.pictures.push_back(draw(plot, "png", folder));
    content.files.push_back(draw(plot, "svg", folder));
    if (plot.format.print) content.files.push_back(draw(plot, "pdf", folder));
}

void add_pdf(const Plot& plot, const std::string& text, const fs::path& folder, SectionContent& content) {
    if (!find_program("gnuplot")) {
        content.caption += " Its PDF needs gnuplot, which is not installed (Debian: apt install gnuplot-nox).";
        return;
    }
    write_file(folder / plot.data, text);
    content.files.push_back(draw(plot, "pdf", folder));
    fs::remove(folder / plot.data);
}

}  // namespace pushfactor::demos
