#include "demos/pages/figure_output.h"

#include "demos/pages/plot.h"
#include "demos/platform/output_file.h"
#include "renderer/images/png.h"

#include <fmt/format.h>

namespace pushfactor::demos::figures {

namespace fs = std::filesystem;

namespace {

// A line per text, for assets/plots/sheet.gp, whose origin is at the bottom left.
std::string text_data(const Sheet& sheet) {
    std::string data;
    for (const SheetText& text : sheet.texts) {
        // The middle of small letters, where gnuplot puts a label.
        const float y = static_cast<float>(sheet.image.height) - text.at.y + 0.36f * text.size;
        data += fmt::format("{}\t{}\t{}\t{}\n", text.at.x, y, text.centred ? 1 : 0, text.text);
    }
    return data;
}

}  // namespace

FigureOutput::FigureOutput(fs::path folder, const FigureFormat& format)
    : folder_(std::move(folder)), format_(format) {}

float FigureOutput::letters(float across) const {
    return format_.print ? static_cast<float>(format_.print->letter_pixels())
                         : static_cast<float>(format_.width) / across;
}

std::string FigureOutput::save(const renderer::Image& image, const std::string& name) const {
    const std::vector<std::uint8_t> bytes = renderer::encode_png(image);
    write_file(folder_ / (name + ".png"), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    return name + ".png";
}

void FigureOutput::save(const Sheet& sheet, const std::string& name, Plate& plate) const {
    plate.pictures.push_back(save(drawn(sheet, studio_.lettering(), format_.theme), name));
    if (!format_.print) return;
    // The picture alone, which gnuplot puts under the texts.
    const fs::path bare = folder_ / save(sheet.image, name + ".bare");
    try {
        add_pdf({.script = "sheet",
                 .data = name + ".txt",
                 .name = name,
                 .width = sheet.image.width,
                 .aspect = static_cast<double>(sheet.image.width) / sheet.image.height,
                 .variables = {{"picture", bare.string()},
                               {"across", static_cast<double>(sheet.image.width)},
                               {"down", static_cast<double>(sheet.image.height)}},
                 .format = format_},
                text_data(sheet), folder_, plate);
    } catch (...) {
        fs::remove(bare);
        throw;
    }
    fs::remove(bare);
}

void FigureOutput::plot(const Table& table, const std::string& name, double aspect, Plate& plate) const {
    // In one column of a page plots are higher, because their letters are not smaller.
    const bool narrow = format_.print && format_.width < 50.0 * format_.print->letter_pixels();
    add_plot({.script = name,
              .data = name + ".csv",
              .name = name,
              .width = format_.width,
              .aspect = narrow ? 0.72 * aspect : aspect,
              .format = format_},
             csv_text(table), folder_, plate);
}

}  // namespace pushfactor::demos::figures
