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
    add_plot({.script = name, .data = name + ".csv", .name = name, .width = width_, .aspect = aspect},
             csv_text(table), folder_, plate);
}

}  // namespace pushfactor::demos::figures
