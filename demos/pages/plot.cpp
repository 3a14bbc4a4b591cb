#include "demos/pages/plot.h"

#include "demos/platform/assets.h"
#include "demos/platform/child_process.h"
#include "demos/platform/output_file.h"
#include "demos/text/errors.h"
#include "demos/text/numbers.h"
#include "demos/text/palette.h"

#include <fmt/format.h>

namespace pushfactor::demos {

namespace {

namespace fs = std::filesystem;

// A gnuplot string: in single quotes, where only the quote itself is special and is doubled.
std::string gnuplot_string(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
    return result + "'";
}

std::string hexadecimal(const Colour& colour) {
    return fmt::format("#{:06x}", number_of(colour));
}

// The palette of the frames as gnuplot variables.
std::string colours() {
    std::string text;
    for (const Colour& colour : palette) {
        text += fmt::format("{} = {}; ", colour.name, gnuplot_string(hexadecimal(colour)));
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

const char* const what_plots_need =
    " The plot needs gnuplot, which is not installed (Debian: apt install gnuplot-nox); its data are here.";

}  // namespace

void add_plot(const Plot& plot, const std::string& text, const fs::path& folder, Plate& plate) {
    write_file(folder / plot.data, text);
    plate.files.push_back(plot.data);
    if (!find_program("gnuplot")) {
        plate.caption += what_plots_need;
        return;
    }
    const fs::path scripts = asset_folder("plots");
    const int height = static_cast<int>(plot.width / plot.aspect);
    for (const std::string format : {"png", "svg"}) {
        const std::string made = plot.name + "." + format;
        const std::string settings =
            fmt::format("{}{}data = {}; made = {}; format = {}; width = {}; height = {}; style = {}", colours(),
                        variables_of(plot), gnuplot_string((folder / plot.data).string()),
                        gnuplot_string((folder / made).string()), gnuplot_string(format), plot.width, height,
                        gnuplot_string((scripts / "style.gp").string()));
        try {
            ChildProcess("gnuplot", "gnuplot-nox", {"-e", settings, (scripts / (plot.script + ".gp")).string()})
                .finish();
        } catch (const ChildProcessError& error) {
            throw OutputError(error.what());
        }
        (format == "png" ? plate.pictures : plate.files).push_back(made);
    }
}

}  // namespace pushfactor::demos
