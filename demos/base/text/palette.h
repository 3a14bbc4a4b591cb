// The palette of frames and plots, sRGB; colour-blind readers can distinguish all colours.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace pushfactor::demos {

struct Colour {
    std::string_view name;
    float red, green, blue;  // 0..1
};

inline constexpr std::array palette{
    Colour{"vermilion", 0.90f, 0.33f, 0.22f}, Colour{"orange", 0.95f, 0.62f, 0.18f},
    Colour{"blue", 0.14f, 0.48f, 0.78f},      Colour{"green", 0.16f, 0.66f, 0.55f},
    Colour{"violet", 0.36f, 0.24f, 0.56f},    Colour{"ivory", 0.88f, 0.85f, 0.78f},
};

// For plots on paper: the same hues, but each lighter than the one before it also in grey, in the order violet,
// blue, vermilion, green, orange, ivory.
inline constexpr std::array print_palette{
    Colour{"vermilion", 0.84f, 0.30f, 0.17f}, Colour{"orange", 0.98f, 0.75f, 0.35f},
    Colour{"blue", 0.05f, 0.38f, 0.66f},      Colour{"green", 0.22f, 0.68f, 0.57f},
    Colour{"violet", 0.27f, 0.14f, 0.45f},    Colour{"ivory", 0.93f, 0.91f, 0.86f},
};

inline std::optional<Colour> find_colour(std::string_view name) {
    for (const Colour& colour : palette) {
        if (colour.name == name) return colour;
    }
    return std::nullopt;
}

// 0xRRGGBB
inline int number_of(const Colour& colour) {
    const auto byte = [](float part) { return static_cast<int>(std::lround(part * 255.0f)); };
    return (byte(colour.red) << 16) + (byte(colour.green) << 8) + byte(colour.blue);
}

// Of the colour with this name; of another name a dark grey.
inline int number_of(std::string_view name) {
    const auto found = find_colour(name);
    return found ? number_of(*found) : 0x444444;
}

}  // namespace pushfactor::demos
