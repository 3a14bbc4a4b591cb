// Plots, drawn by gnuplot with the scripts of assets/plots and the palette of the frames.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pushfactor::demos {

struct Plot {
    std::string script;          // assets/plots/SCRIPT.gp
    std::filesystem::path data;  // what the script reads
    std::string name;            // of the files that are made, without ending
    int width = 1600;            // pixels
    double aspect = 1.6;         // width over height
    // What else the script wants to know, by the names of its variables.
    std::vector<std::pair<std::string, std::variant<double, std::string>>> variables{};
};

// Whether gnuplot is installed, and what to say where it is not.
bool plots_can_be_drawn();
inline const char* const what_plots_need =
    "The plot needs gnuplot, which is not installed (Debian: apt install gnuplot-nox); its data are here.";

// Makes NAME.png and NAME.svg in `folder` and gives those names. Throws OutputError with gnuplot's own words.
std::vector<std::string> draw_plot(const Plot& plot, const std::filesystem::path& folder);

}  // namespace pushfactor::demos
