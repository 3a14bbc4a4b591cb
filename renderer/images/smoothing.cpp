#include "renderer/images/smoothing.h"

#include "renderer/images/light_bytes.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace pushfactor::renderer {
namespace {

// Differences of brightness below these are not seen as edges: levels, and a share of the brighter side.
constexpr int least_contrast = 6;
constexpr int least_share = 16;  // one part in so many

// Pixels so near to the edge of the image lack neighbours, and stay as they are.
constexpr int border = 2;

// How far a step is followed, and then how far the edge must run on beyond it, pixels.
constexpr int longest_walk = 12;
constexpr int most_run_on = 3;
static_assert(longest_walk + most_run_on < smoothing_reach);

// Of a pixel, 0..255.
constexpr std::uint8_t brightness(const std::uint8_t* rgba) {
    return static_cast<std::uint8_t>((77 * rgba[0] + 150 * rgba[1] + 29 * rgba[2]) >> 8);
}

// One pixel and what is around it. Places are steps in memory, of one pixel: `row` leads to the one above.
class Edge {
  public:
    Edge(const std::uint8_t* pixel, std::ptrdiff_t row) : pixel_(pixel), row_(row) {}

    // Whether the edge runs more along the row than across it.
    bool is_level() const {
        const auto bend = [this](std::ptrdiff_t place, std::ptrdiff_t step) {
            return std::abs(at(place + step) + at(place - step) - 2 * at(place));
        };
        return 2 * bend(0, row_) + bend(1, row_) + bend(-1, row_) >=
               2 * bend(0, 1) + bend(row_, 1) + bend(-row_, 1);
    }

    int at(std::ptrdiff_t place) const { return brightness(pixel_ + 4 * place); }

    bool is_marked(std::ptrdiff_t place) const { return pixel_[4 * place + 3] != 0; }

    // The pixel's bytes and those of another one.
    const std::uint8_t* bytes(std::ptrdiff_t place) const { return pixel_ + 4 * place; }

  private:
    const std::uint8_t* pixel_;
    std::ptrdiff_t row_;
};

struct Walk {
    int length;  // pixels, to the first one beyond the end of the step
    int turn;    // which side goes on there: 1 the neighbour's, -1 the pixel's own, 0 neither: a corner, or too far

    float to_end() const { return static_cast<float>(length) - 0.5f; }
};

// The step between a pixel and its neighbour `across`.
class Step {
  public:
    Step(const Edge& edge, std::ptrdiff_t across)
        : edge_(edge), across_(across), own_(edge.at(0)), rise_(edge.at(across) - own_) {}

    // Follows it `along`, for at most `most` pixels.
    Walk follow(std::ptrdiff_t along, int most) const {
        for (int length = 1; length <= most; ++length) {
            const std::ptrdiff_t place = length * along;
            const int beyond = edge_.at(place) + edge_.at(place + across_) - (2 * own_ + rise_);
            if (2 * std::abs(beyond) < std::abs(rise_)) continue;
            // An edge that runs on has moved by one pixel, and on the other side of that nothing has changed.
            if ((beyond > 0) == (rise_ > 0)) return {length, is_own(place - across_) ? 1 : 0};
            return {length, is_own(place + 2 * across_) ? 0 : -1};
        }
        return {most + 1, 0};
    }

    // Whether the edge, moved to the pixel's own side at `place`, stays there for so many pixels more.
    bool runs_on(std::ptrdiff_t place, std::ptrdiff_t along, int pixels) const {
        for (int i = 1; i <= pixels; ++i) {
            place += along;
            if (is_own(place) || !is_own(place - across_)) return false;
        }
        return true;
    }

  private:
    bool is_own(std::ptrdiff_t place) const { return 2 * std::abs(edge_.at(place) - own_) < std::abs(rise_); }

    const Edge& edge_;
    std::ptrdiff_t across_;
    int own_;   // brightness
    int rise_;  // of the neighbour above it
};

// How much of the pixel belongs to its neighbour `across`, 0 to 0.5, for an edge along `along`. There are `before`
// and `after` pixels of the image to its two sides.
float share_of_neighbour(const Edge& edge, std::ptrdiff_t along, std::ptrdiff_t across, int before, int after) {
    const Step step(edge, across);
    const Walk back = step.follow(-along, std::min(before - most_run_on, longest_walk));
    const Walk forth = step.follow(along, std::min(after - most_run_on, longest_walk));
    const bool is_back = back.length < forth.length;
    const Walk& nearer = is_back ? back : forth;
    if (nearer.turn <= 0) return 0.0f;
    // Where a long straight edge ends in a short bevel it does not lean that way.
    const std::ptrdiff_t onward = is_back ? -along : along;
    const int run_on = std::min((back.length + forth.length) / 4, most_run_on);
    if (!step.runs_on(nearer.length * onward, onward, run_on)) return 0.0f;
    return std::max(0.5f - nearer.to_end() / (back.to_end() + forth.to_end()), 0.0f);
}

void mix(const std::uint8_t* pixel, const std::uint8_t* neighbour, float share, std::uint8_t* to) {
    for (int channel = 0; channel < 3; ++channel) {
        const float own = light_of_byte(pixel[channel]);
        to[channel] = byte_of_light(own + share * (light_of_byte(neighbour[channel]) - own));
    }
}

// Four bytes at a time, of which the next pixel replaces the last.
void copy_colours(const std::uint8_t* rgba, std::ptrdiff_t count, std::uint8_t* rgb) {
    for (std::ptrdiff_t i = 0; i < count - 1; ++i) std::memcpy(rgb + 3 * i, rgba + 4 * i, 4);
    if (count > 0) std::memcpy(rgb + 3 * (count - 1), rgba + 4 * (count - 1), 3);
}

// Finds the pixels of an area at which an edge is seen and marked, or next to a marked one. All pixels around the
// area have to be of the image. It does the same for all pixels of a row, as fast as they can be read.
class EdgeFinder {
  public:
    EdgeFinder(const std::uint8_t* rgba, std::ptrdiff_t row, const PixelArea& area)
        : width_(area.width), stride_(area.width + 2) {
        const auto count = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(area.height + 2);
        levels_.resize(count);
        marks_.resize(count);
        found_.resize(static_cast<std::size_t>(width_));
        for (int y = -1; y <= area.height; ++y) {
            const std::uint8_t* const pixels = rgba + 4 * (row * (area.y + y) + area.x - 1);
            split(pixels, stride_, &levels_[start_of(y)], &marks_[start_of(y)]);
        }
    }

    // One for each pixel of the area's row: not 0 where there is one.
    std::span<const std::uint8_t> in_row(int y) {
        find(&levels_[start_of(y) + 1], &marks_[start_of(y) + 1], stride_, width_, found_.data());
        return found_;
    }

  private:
    std::size_t start_of(int y) const {
        return static_cast<std::size_t>(stride_) * static_cast<std::size_t>(y + 1);
    }

    static void split(const std::uint8_t* rgba, std::ptrdiff_t count, std::uint8_t* levels, std::uint8_t* marks) {
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            levels[i] = brightness(rgba + 4 * i);
            marks[i] = rgba[4 * i + 3];
        }
    }

    static void find(const std::uint8_t* levels, const std::uint8_t* marks, int stride, int count,
                     std::uint8_t* found) {
        for (int i = 0; i < count; ++i) {
            const std::uint8_t* const level = levels + i;
            const std::uint8_t* const mark = marks + i;
            const int least = std::min({level[0], level[-1], level[1], level[-stride], level[stride]});
            const int most = std::max({level[0], level[-1], level[1], level[-stride], level[stride]});
            const int near = mark[0] | mark[-1] | mark[1] | mark[-stride] | mark[stride];
            const bool seen = most - least >= std::max(least_contrast, most / least_share);
            found[i] = static_cast<std::uint8_t>(seen ? near : 0);
        }
    }

    int width_;
    int stride_;  // of levels and marks, which have one pixel more to each side
    std::vector<std::uint8_t> levels_;
    std::vector<std::uint8_t> marks_;
    std::vector<std::uint8_t> found_;
};

// Puts the smoothed pixel to `to`, if there is anything to smooth.
void smooth_pixel(const Edge& edge, std::ptrdiff_t row, const glm::ivec2& place, const glm::ivec2& size,
                  std::uint8_t* to) {
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

// The part of an area that is not too near to the edge of the image.
PixelArea inner_part(const PixelArea& area, const glm::ivec2& size) {
    const int x = std::max(area.x, border);
    const int y = std::max(area.y, border);
    return {.x = x,
            .y = y,
            .width = std::max(std::min(area.x + area.width, size.x - border) - x, 0),
            .height = std::max(std::min(area.y + area.height, size.y - border) - y, 0)};
}

}  // namespace

void smooth_edges(std::span<const std::uint8_t> rgba, std::span<const PixelArea> areas, Image& image) {
    const glm::ivec2 size(image.width, image.height);
    const std::ptrdiff_t row = size.x;
    const auto from = [&](int x, int y) { return rgba.data() + 4 * (row * y + x); };
    const auto to = [&](int x, int y) { return image.rgb.data() + 3 * (row * (size.y - 1 - y) + x); };
    for (const PixelArea& area : areas) {
        for (int y = area.y; y < area.y + area.height; ++y)
            copy_colours(from(area.x, y), area.width, to(area.x, y));
        const PixelArea inner = inner_part(area, size);
        if (inner.width == 0 || inner.height == 0) continue;
        EdgeFinder edges(rgba.data(), row, inner);
        for (int i = 0; i < inner.height; ++i) {
            const std::span<const std::uint8_t> found = edges.in_row(i);
            const int y = inner.y + i;
            for (int x = inner.x; x < inner.x + inner.width; ++x) {
                if (found[static_cast<std::size_t>(x - inner.x)] == 0) continue;
                smooth_pixel(Edge(from(x, y), row), row, {x, y}, size, to(x, y));
            }
        }
    }
}

}  // namespace pushfactor::renderer
