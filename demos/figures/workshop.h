// What figures are made with: a folder, a width, a studio, and gnuplot for plots.
#pragma once

#include "demos/choices.h"
#include "demos/figures/table.h"
#include "demos/pictures/studio.h"

#include <filesystem>
#include <initializer_list>
#include <string>
#include <utility>

namespace pushfactor::demos::figures {

struct Plate;

// Names without dashes, and texts, as on the command line.
using Options = std::vector<std::pair<std::string, std::string>>;

// A run of a scene of the catalogue, or of a file in assets/scenes.
Choices run_of(const std::string& scene, const Options& options);

// "pushfactor render stack --preset paper"
std::string command_text(const std::string& command, const std::string& scene, const Options& options);

class Workshop {
  public:
    Workshop(std::filesystem::path folder, int width, int samples);

    int width() const { return width_; }      // pixels, of every figure
    int samples() const { return samples_; }  // drawings that a picture is the mean of
    pictures::Studio& studio() { return studio_; }

    // Writes the picture as NAME.png and gives that name. Throws OutputError.
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
