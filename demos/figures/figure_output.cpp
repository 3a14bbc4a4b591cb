#include "demos/figures/figure_output.h"

#include "demos/base/platform/output_file.h"
#include "demos/figures/plot.h"
#include "renderer/images/png.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos::figures {

namespace fs = std::filesystem;

namespace {

// A line per text, for assets/plots/sheet.gp, whose origin is at the bottom left.
std::string text_data(const Sheet& sheet) {
    std::string data;
    for (const SheetText& text : sheet.texts) {
        // The middle of small letters, where gnuplot puts a label.
        const float y = static_cast<float>(sheet.height()) - text.at.y + 0.36f * text.size;
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
    write_file(folder_ / (name + ".png"), renderer::encode_png(image));
    return name + ".png";
}

SectionContent FigureOutput::save(const Sheet& sheet, const Figure& figure) const {
    const std::string name(figure.name);
    write_file(folder_ / (name + ".png"), png_of(sheet, offscreen_.lettering(), format_));
    SectionContent content{.pictures = {name + ".png"}};
    if (!format_.print) return content;
    // The picture alone, which gnuplot puts under the texts; its destructor removes it.
    const StagedFile bare(folder_ / (name + ".png"), ".png");
    write_file(bare.path(), png_of(sheet, 0.0));
    add_pdf({.script = "sheet",
             .data = name + ".txt",
             .name = name,
             .width = sheet.width(),
             .aspect = static_cast<double>(sheet.width()) / sheet.height(),
             .variables = {{"picture", bare.path().string()},
                           {"across", static_cast<double>(sheet.width())},
                           {"down", static_cast<double>(sheet.height())}},
             .format = format_},
            text_data(sheet), folder_, content);
    return content;
}

SectionContent FigureOutput::plot(const Figure& figure, const Table& table, double aspect,
                                  SectionContent content) const {
    const std::string name(figure.name);
    // In one column of a page plots are higher, because their letters are not smaller.
    const bool narrow = format_.print && format_.width < 50.0 * format_.print->letter_pixels();
    add_plot({.script = name,
              .data = name + ".csv",
              .name = name,
              .width = format_.width,
              .aspect = narrow ? std::min(0.72 * aspect, 1.2) : aspect,
              .format = format_},
             csv_text(table), folder_, content);
    return content;
}

}  // namespace pushfactor::demos::figures
