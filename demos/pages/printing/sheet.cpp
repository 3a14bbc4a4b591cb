#include "demos/pages/printing/sheet.h"

#include <sstream>

namespace pushfactor::demos {

Sheet Sheet::blank(int width, int height, Theme theme) {
    const glm::vec3 paper = theme == Theme::dark ? glm::vec3(0.086f, 0.094f, 0.114f) : glm::vec3(1.0f);
    return {.image = renderer::blank_image(width, height, paper), .texts = {}};
}

renderer::Image drawn(const Sheet& sheet, const pictures::Lettering& lettering, Theme theme) {
    renderer::Image image = sheet.image;
    const glm::vec3 ink = theme == Theme::dark ? glm::vec3(0.91f) : pictures::Lettering::ink_colour;
    for (const SheetText& text : sheet.texts) {
        lettering.text(image, text.text, text.at, text.size, text.centred, ink);
    }
    return image;
}

std::vector<std::string> wrapped(const std::string& text, float size, float width,
                                 const pictures::Lettering& lettering) {
    std::vector<std::string> lines(1);
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        std::string& line = lines.back();
        const std::string longer = line.empty() ? word : line + ' ' + word;
        if (line.empty() || lettering.width(longer, size) <= width) {
            line = longer;
        } else {
            lines.push_back(word);
        }
    }
    return lines;
}

}  // namespace pushfactor::demos
