#include "demos/pages/figure_output.h"

#include "demos/pages/plot.h"
#include "demos/platform/output_file.h"
#include "renderer/images/png.h"

namespace pushfactor::demos::figures {

namespace fs = std::filesystem;

FigureOutput::FigureOutput(fs::path folder, int width, int samples)
    : folder_(std::move(folder)), width_(width), samples_(samples) {}

std::string FigureOutput::save(const renderer::Image& image, const std::string& name) const {
    const std::vector<std::uint8_t> bytes = renderer::encode_png(image);
    write_file(folder_ / (name + ".png"), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    return name + ".png";
}

void FigureOutput::plot(const Table& table, const std::string& name, double aspect, Plate& plate) const {
    const fs::path csv = folder_ / (name + ".csv");
    write_file(csv, csv_text(table));
    plate.files.push_back(name + ".csv");
    if (!plots_can_be_drawn()) {
        plate.caption += std::string(" ") + what_plots_need;
        return;
    }
    const Plot plot{.script = name, .data = csv, .name = name, .width = width_, .aspect = aspect};
    for (const std::string& made : draw_plot(plot, folder_)) {
        (made.ends_with(".png") ? plate.pictures : plate.files).push_back(made);
    }
}

}  // namespace pushfactor::demos::figures
