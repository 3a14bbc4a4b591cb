#include "renderer/smoothing.h"

#include "renderer/light_bytes.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace pushfactor::renderer {
namespace {

// Differences of brightness below these are not seen as edges: levels, and a share of the brighter side.
constexpr int least_contrast = 6;
constexpr int least_share = 16;  // one part in so many

// Pixels so near to the edge of the image lack neighbours, and stay as they are.
constexpr int border = 2;

// One pixel and what is around it. Places are steps in memory, of one pixel: `row` leads to the one above.
class Edge {
  public:
    Edge(const std::uint8_t* pixel, std::ptrdiff_t row) : pixel_(pixel), row_(row) {}

    bool is_seen() const {
        const auto [least, most] = std::minmax({at(0), at(1), at(-1), at(row_), at(-row_)});
        return most - least >= std::max(least_contrast, most / least_share);
    }

    // Whether the edge runs more along the row than across it.
    bool is_level() const {
        const auto bend = [this](std::ptrdiff_t place, std::ptrdiff_t step) {
            return std::abs(at(place + step) + at(place - step) - 2 * at(place));
        };
        return 2 * bend(0, row_) + bend(1, row_) + bend(-1, row_) >=
               2 * bend(0, 1) + bend(row_, 1) + bend(-row_, 1);
    }

    // Brightness, 0..255.
    int at(std::ptrdiff_t place) const {
        const std::uint8_t* pixel = pixel_ + 4 * place;
        return (77 * pixel[0] + 150 * pixel[1] + 29 * pixel[2]) >> 8;
    }

    bool is_marked(std::ptrdiff_t place) const { return pixel_[4 * place + 3] != 0; }

    // The pixel's bytes and those of another one.
    const std::uint8_t* bytes(std::ptrdiff_t place) const { return pixel_ + 4 * place; }

  private:
    const std::uint8_t* pixel_;
    std::ptrdiff_t row_;
};

struct Walk {
    float length;  // pixels, to where the step ends
    int turn;  // which side goes on there: 1 the neighbour's, -1 the pixel's own, 0 neither: a corner, or too far
};

// Follows the step between a pixel and its neighbour `across`, `along` it, for at most `most` pixels.
Walk follow(const Edge& edge, std::ptrdiff_t along, std::ptrdiff_t across, int most) {
    const int own = edge.at(0);
    const int rise = edge.at(across) - own;
    const auto is_own = [&](std::ptrdiff_t place) { return 2 * std::abs(edge.at(place) - own) < std::abs(rise); };
    for (int length = 1; length <= most; ++length) {
        const std::ptrdiff_t place = length * along;
        const int beyond = edge.at(place) + edge.at(place + across) - (2 * own + rise);
        if (2 * std::abs(beyond) < std::abs(rise)) continue;
        const float to_end = static_cast<float>(length) - 0.5f;
        // An edge that runs on has moved by one pixel, and on the other side of that nothing has changed.
        if ((beyond > 0) == (rise > 0)) return {to_end, is_own(place - across) ? 1 : 0};
        return {to_end, is_own(place + 2 * across) ? 0 : -1};
    }
    return {static_cast<float>(most) + 0.5f, 0};
}

// How much of the pixel belongs to its neighbour `across`, 0 to 0.5, for an edge along `along`. There are `before`
// and `after` pixels of the image to its two sides.
float share_of_neighbour(const Edge& edge, std::ptrdiff_t along, std::ptrdiff_t across, int before, int after) {
    const Walk back = follow(edge, -along, across, std::min(before, smoothing_reach - 2));
    const Walk forth = follow(edge, along, across, std::min(after, smoothing_reach - 2));
    const Walk& nearer = back.length < forth.length ? back : forth;
    if (nearer.turn <= 0) return 0.0f;
    return std::max(0.5f - nearer.length / (back.length + forth.length), 0.0f);
}

void mix(const std::uint8_t* pixel, const std::uint8_t* neighbour, float share, std::uint8_t* to) {
    for (int channel = 0; channel < 3; ++channel) {
        const float own = light_of_byte(pixel[channel]);
        to[channel] = byte_of_light(own + share * (light_of_byte(neighbour[channel]) - own));
    }
}

void copy_colours(const std::uint8_t* rgba, int count, std::uint8_t* rgb) {
    for (int i = 0; i < count; ++i) {
        for (int channel = 0; channel < 3; ++channel) rgb[3 * i + channel] = rgba[4 * i + channel];
    }
}

// Puts the smoothed pixel to `to`, if there is anything to smooth.
void smooth_pixel(const Edge& edge, std::ptrdiff_t row, const glm::ivec2& place, const glm::ivec2& size,
                  std::uint8_t* to) {
    if (!edge.is_seen()) return;
    const bool level = edge.is_level();
    const std::ptrdiff_t along = level ? 1 : row;
    const std::ptrdiff_t up = level ? row : 1;
    const bool upwards = std::abs(edge.at(up) - edge.at(0)) >= std::abs(edge.at(-up) - edge.at(0));
    const std::ptrdiff_t across = upwards ? up : -up;
    if (!edge.is_marked(0) && !edge.is_marked(across)) return;
    const int axis = level ? 0 : 1;
    const float share = share_of_neighbour(edge, along, across, place[axis], size[axis] - 1 - place[axis]);
    if (share > 0.0f) mix(edge.bytes(0), edge.bytes(across), share, to);
}

}  // namespace

void smooth_edges(std::span<const std::uint8_t> rgba, std::span<const PixelArea> areas, Image& image) {
    const glm::ivec2 size(image.width, image.height);
    const std::ptrdiff_t row = size.x;
    for (const PixelArea& area : areas) {
        const int first = std::max(area.x, border) - area.x;
        const int end = std::min(area.x + area.width, size.x - border) - area.x;
        for (int y = area.y; y < area.y + area.height; ++y) {
            const std::uint8_t* pixel = &rgba[static_cast<std::size_t>(4 * (row * y + area.x))];
            std::uint8_t* to = &image.rgb[static_cast<std::size_t>(3 * (row * (size.y - 1 - y) + area.x))];
            copy_colours(pixel, area.width, to);
            if (y < border || y >= size.y - border) continue;
            for (int i = first; i < end; ++i) {
                const std::uint8_t* const here = pixel + 4 * i;
                const int near = here[3] | here[-1] | here[7] | here[3 + 4 * row] | here[3 - 4 * row];
                if (near != 0) smooth_pixel(Edge(here, row), row, {area.x + i, y}, size, to + 3 * i);
            }
        }
    }
}

}  // namespace pushfactor::renderer
