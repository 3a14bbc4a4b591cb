// The figures, and what they are written with: a folder, a format, a renderer, and gnuplot for plots.
#pragma once

#include "demos/figures/printing/format.h"
#include "demos/figures/printing/sheet.h"
#include "demos/options/named_run.h"
#include "demos/pages/page.h"
#include "demos/pictures/offscreen_renderer.h"

#include <filesystem>
#include <string>

namespace pushfactor::demos::figures {

struct Figure;
class FigureOutput;
using MakeFigure = SectionContent(FigureOutput& output, const Figure& figure);

struct Figure {
    std::string_view name;  // also the stem of its files
    std::string_view title;
    MakeFigure* make;
};

class FigureOutput {
  public:
    FigureOutput(std::filesystem::path folder, const FigureFormat& format);

    int width() const { return format_.width; }      // pixels, of every figure
    int samples() const { return format_.samples; }  // renderings averaged per picture
    const FigureFormat& format() const { return format_; }
    pictures::OffscreenRenderer& offscreen() { return offscreen_; }
    std::filesystem::path file(const std::string& name) const { return folder_ / name; }

    // Size of the font in pixels: that of the print; on a screen so many of them fit across a figure.
    float letters(float across) const;

    // Writes the picture as NAME.png and returns that name. Throws OutputError.
    std::string save(const renderer::Image& image, const std::string& name) const;

    // Writes the sheet as NAME.png, NAME being the figure's, and, for print, as NAME.pdf. The content with these
    // files. Throws OutputError.
    SectionContent save(const Sheet& sheet, const Figure& figure) const;

    // Writes NAME.csv and, where gnuplot is installed, draws it with assets/plots/NAME.gp
    // as NAME.png, NAME.svg and, for print, NAME.pdf. The content with these files; without gnuplot its caption
    // says what to install.
    SectionContent plot(const Figure& figure, const Table& table, double aspect, SectionContent content) const;

  private:
    std::filesystem::path folder_;
    FigureFormat format_;
    pictures::OffscreenRenderer offscreen_;
};

// In page order: the paper's by number, then ours.
std::span<const Figure> all_figures();

MakeFigure push_error, stack_over_time, intersecting_stack, funnel, pendulum_grid, pendulum_wave, sphere_in_corner;
MakeFigure push_against_beta, push_pump, intersecting_motion, pendulum_energy, arch_thickness, domino_speed;
MakeFigure platonic_energy, stack_forces;

}  // namespace pushfactor::demos::figures
