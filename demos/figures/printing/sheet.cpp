#include "demos/figures/printing/sheet.h"

#include "renderer/images/cut_out.h"
#include "renderer/images/png.h"

namespace pushfactor::demos {

Sheet Sheet::blank(int width, int height, const FigureFormat& format) {
    const glm::vec3 white(1.0f), night(0.086f, 0.094f, 0.114f), offscreen = renderer::Background().colour;
    Sheet sheet;
    if (format.background == Background::none) {
        // Far enough apart for all opacities, and both can be exposed.
        for (const float grey : {0.02f, 0.98f}) {
            sheet.layers.push_back({.paper = glm::vec3(grey), .behind = glm::vec3(grey)});
        }
    } else {
        const bool dark = format.theme == Theme::dark;
        sheet.layers.push_back({.paper = dark ? night : white, .behind = dark ? 2.0f * night : offscreen});
    }
    for (SheetLayer& layer : sheet.layers) layer.image = renderer::blank_image(width, height, layer.paper);
    return sheet;
}

void Sheet::paste(pictures::OffscreenRenderer& offscreen, renderer::Picture picture, const pictures::Size& size,
                  int samples, int x, int y) {
    const bool cut_out = layers.size() > 1;
    if (cut_out) picture.ground.reset();
    for (SheetLayer& layer : layers) {
        picture.background = {.colour = layer.behind, .haze = !cut_out};
        renderer::paste(layer.image, offscreen.draw(picture, size, samples), x, y);
    }
}

std::vector<std::uint8_t> png_of(const Sheet& sheet, double dots_per_inch) {
    const renderer::PngNotes notes{.dots_per_inch = dots_per_inch, .film = {}};
    const SheetLayer &first = sheet.layers.front(), &last = sheet.layers.back();
    return sheet.layers.size() == 1
               ? renderer::encode_png(first.image, notes)
               : renderer::encode_png(renderer::cut_out(first.image, first.paper, last.image, last.paper), notes);
}

std::vector<std::uint8_t> png_of(Sheet sheet, const pictures::Lettering& lettering, const FigureFormat& format) {
    const glm::vec3 ink = format.theme == Theme::dark ? glm::vec3(0.91f) : pictures::Lettering::ink_colour;
    for (SheetLayer& layer : sheet.layers) {
        for (const SheetText& text : sheet.texts) {
            lettering.text(layer.image, text.text, text.at, text.size, text.centred, ink);
        }
    }
    return png_of(sheet, format.print ? format.print->dpi : 0.0);
}

}  // namespace pushfactor::demos
