// Output of figures: a folder, a width, a studio, and gnuplot for plots.
#pragma once

#include "demos/options/named_run.h"
#include "demos/pages/page.h"
#include "demos/pages/table.h"
#include "demos/pictures/studio.h"

#include <filesystem>
#include <string>

namespace pushfactor::demos::figures {

class FigureOutput {
  public:
    FigureOutput(std::filesystem::path folder, int width, int samples);

    int width() const { return width_; }      // pixels, of every figure
    int samples() const { return samples_; }  // renderings averaged per picture
    pictures::Studio& studio() { return studio_; }
    std::filesystem::path file(const std::string& name) const { return folder_ / name; }

    // Writes the picture as NAME.png and returns that name. Throws OutputError.
    std::string save(const renderer::Image& image, const std::string& name) const;

    // Writes NAME.csv and, where gnuplot is installed, draws it with assets/plots/NAME.gp as NAME.png and NAME.svg.
    // Adds the files to the plate; without gnuplot its caption says what to install.
    void plot(const Table& table, const std::string& name, double aspect, Plate& plate) const;

  private:
    std::filesystem::path folder_;
    int width_, samples_;
    pictures::Studio studio_;
};

}  // namespace pushfactor::demos::figures
