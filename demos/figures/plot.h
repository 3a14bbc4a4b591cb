// Plots, drawn by gnuplot with the scripts of assets/plots and the palette of the frames.
#pragma once

#include "demos/figures/printing/format.h"
#include "demos/pages/page.h"

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pushfactor::demos {

struct Plot {
    std::string script;   // assets/plots/SCRIPT.gp
    std::string data;     // name of the file that the script reads
    std::string name;     // of the output files, without extension
    int width = 1600;     // pixels
    double aspect = 1.6;  // width over height
    // Other variables of the script, by name.
    std::vector<std::pair<std::string, std::variant<double, std::string>>> variables{};
    FigureFormat format{};  // its width and samples are not used
};

// Writes `text` as the plot's data into `folder` and, where gnuplot is installed, draws NAME.png, NAME.svg and, for
// print, NAME.pdf. Adds the files to the content; without gnuplot its caption says what to install. Throws
// OutputError with the message of gnuplot.
void add_plot(const Plot& plot, const std::string& text, const std::filesystem::path& folder,
              SectionContent& content);

// The same as NAME.pdf alone, without data among the content's files.
void add_pdf(const Plot& plot, const std::string& text, const std::filesystem::path& folder,
             SectionContent& content);

}  // namespace pushfactor::demos
