#include "demos/pictures/lettering.h"

#include "demos/base/text/numbers.h"
#include "demos/options/simulation_options.h"
#include "demos/pictures/to_glm.h"

#include <algorithm>

namespace pushfactor::demos::pictures {

namespace {

using renderer::Image;
using renderer::Rectangle;

const renderer::Paint ink{.colour = Lettering::ink_colour};
const renderer::Paint paper{.colour = glm::vec3(1.0f), .opacity = 0.72f};

}  // namespace

float letter_size(int height) {
    return std::clamp(static_cast<float>(height) / 36.0f, 11.0f, 64.0f);
}

float legend_height(std::size_t lines, float size) {
    return (1.5f * static_cast<float>(lines) + 1.5f) * size;
}

Lettering::Lettering() : font_(font_file()) {}

std::string Lettering::font_file() {
    return PUSHFACTOR_FONT;
}

void Lettering::text(Image& image, const std::string& text, glm::vec2 at, float size, bool centred,
                     const glm::vec3& colour) const {
    if (centred) at.x -= 0.5f * font_.width(text, size);
    font_.draw(image, text, at, size, {.colour = colour});
}

std::string Lettering::cut(const std::string& text, float size, float width, bool keep_end) const {
    if (font_.width(text, size) <= width) return text;
    const auto continues = [&](std::size_t at) {  // a character in UTF-8
        return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u;
    };
    std::string shorter;
    std::size_t gone = 0;
    do {
        ++gone;
        while (continues(keep_end ? gone : text.size() - gone)) ++gone;
        shorter = keep_end ? "…" + text.substr(gone) : text.substr(0, text.size() - gone) + "…";
    } while (gone < text.size() && font_.width(shorter, size) > width);
    return shorter;
}

void Lettering::plate(Image& image, const Rectangle& in, const std::string& text, float size, bool below) const {
    const float space = 0.5f * size;  // around the plate, and left and right of its text
    const std::string line = cut(text, size, in.width - 4.0f * space, !below);
    const float height = 1.6f * size;
    const float top = below ? in.y + in.height - space - height : in.y + space;
    const Rectangle plate{in.x + space, top, font_.width(line, size) + 2.0f * space, height};
    renderer::fill(image, plate, paper, 0.25f * size);
    font_.draw(image, line, {plate.x + space, plate.y + 1.15f * size}, size, ink);
}

void Lettering::name(Image& image, const Rectangle& in, const std::string& text, float size) const {
    plate(image, in, text, size, false);
}

void Lettering::caption(Image& image, const Rectangle& in, const std::string& text, float size) const {
    plate(image, in, text, size, true);
}

float Lettering::legend(Image& image, const Rectangle& in, const std::vector<LegendLine>& lines, float size) const {
    if (lines.empty()) return 0.0f;
    const float space = 0.5f * size;
    const float line_height = 1.5f * size;
    const float thickness = std::max(1.5f, 0.16f * size);
    float text_width = 0.0f;
    float key_width = 2.0f * size;
    for (const LegendLine& line : lines) {
        text_width = std::max(text_width, font_.width(line.text, size));
        key_width = std::max(key_width, line.arrow);
    }
    const float width = key_width + text_width + 3.0f * space;
    const float height = line_height * static_cast<float>(lines.size()) + space;
    const Rectangle plate{in.x + in.width - width - space, in.y + in.height - height - space, width, height};
    renderer::fill(image, plate, paper, 0.25f * size);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const float middle = plate.y + 0.5f * space + (static_cast<float>(i) + 0.5f) * line_height;
        const float right = plate.x + space + key_width;
        const renderer::Paint paint{.colour = to_glm(lines[i].colour)};
        if (lines[i].arrow > 0.0f) {
            renderer::draw_arrow(image, {right - lines[i].arrow, middle}, {right, middle}, thickness, paint);
        } else {
            renderer::draw_dot(image, {right - size, middle}, 0.28f * size, paint);
        }
        font_.draw(image, lines[i].text, {right + space, middle + 0.36f * size}, size, ink);
    }
    return width + space;
}

std::string caption_of(const Choices& choices) {
    const std::string compared = choices.frames.compare ? choices.frames.compare->option : "";
    std::string caption = choices.description.name;
    const auto add = [&](const std::string& name, const std::string& value) {
        if (name != compared) caption += "   " + name + " " + value;
    };
    add("preset", choices.settings.preset);
    const Settings preset = preset_settings(choices.settings.preset);
    for (const SimulationOption& option : simulation_options()) {
        const std::string value = option.get(choices.settings);
        if (option.name != "seconds" && value != option.get(preset)) add(option.name, value);
    }
    const SceneEntry* const scene = find_scene(choices.scene);
    for (std::size_t i = 0; scene && i < scene->parameters.size(); ++i) {
        const Parameter& parameter = scene->parameters[i];
        const auto& [name, value] = choices.parameters[i];
        if (value != to_text(parameter.fallback)) add(name, value);
    }
    return caption;
}

}  // namespace pushfactor::demos::pictures
