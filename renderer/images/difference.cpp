#include "renderer/images/difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>

namespace pushfactor::renderer {

namespace {

int level_at(const Image& a, const Image& b, std::size_t pixel) {
    int largest = 0;
    for (std::size_t k = 3 * pixel; k < 3 * pixel + 3; ++k)
        largest = std::max(largest, std::abs(a.rgb[k] - b.rgb[k]));
    return largest;
}

struct Stop {
    float at;  // error, 0..1
    std::array<float, 3> colour;
};

// Colours of errors: lighter is larger, so that they can be told apart in grey. The first is that of the smallest.
constexpr std::array stops{Stop{0.0f, {110, 20, 30}}, Stop{0.1f, {190, 50, 20}}, Stop{0.4f, {250, 150, 30}},
                           Stop{1.0f, {255, 255, 235}}};

void paint(std::uint8_t* pixel, float error) {
    std::size_t next = 1;
    while (next + 1 < stops.size() && error > stops[next].at) ++next;
    const Stop &low = stops[next - 1], &high = stops[next];
    const float share = std::clamp((error - low.at) / (high.at - low.at), 0.0f, 1.0f);
    for (std::size_t k = 0; k < 3; ++k) {
        pixel[k] = static_cast<std::uint8_t>(std::lround(low.colour[k] + share * (high.colour[k] - low.colour[k])));
    }
}

// Shows where in the picture a difference is.
Image faint(const Image& image) {
    Image grey{.width = image.width, .height = image.height, .rgb = std::vector<std::uint8_t>(image.rgb.size())};
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        const int sum = image.rgb[i] + image.rgb[i + 1] + image.rgb[i + 2];
        std::fill_n(grey.rgb.begin() + static_cast<std::ptrdiff_t>(i), 3, static_cast<std::uint8_t>(sum / 12));
    }
    return grey;
}

}  // namespace

ImageDifference::ImageDifference(const Image& a, const Image& b) {
    assert(a.width == b.width && a.height == b.height);
    const std::size_t count = a.rgb.size() / 3;
    count_ = static_cast<long>(count);
    double squares = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const int level = level_at(a, b, i);
        ++pixels_[static_cast<std::size_t>(level)];
        if (level == 0) continue;
        for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
            const double difference = a.rgb[k] - b.rgb[k];
            squares += difference * difference;
        }
    }
    if (count > 0) rms_ = std::sqrt(squares / static_cast<double>(a.rgb.size()));
}

int ImageDifference::largest() const {
    for (int level = 255; level > 0; --level) {
        if (pixels_[static_cast<std::size_t>(level)] > 0) return level;
    }
    return 0;
}

long ImageDifference::pixels_above(int level) const {
    long sum = 0;
    for (int i = level + 1; i < 256; ++i) sum += pixels_[static_cast<std::size_t>(i)];
    return sum;
}

double ImageDifference::share_above(int level) const {
    return count_ > 0 ? static_cast<double>(pixels_above(level)) / static_cast<double>(count_) : 0.0;
}

double ImageDifference::similarity() const {
    return rms_ > 0.0 ? 20.0 * std::log10(255.0 / rms_) : std::numeric_limits<double>::infinity();
}

Image heat_map(const Image& a, const Image& b) {
    Image map = faint(a);
    for (std::size_t i = 0; i < a.rgb.size() / 3; ++i) {
        const int level = level_at(a, b, i);
        if (level > 0) paint(&map.rgb[3 * i], static_cast<float>(level) / 255.0f);
    }
    return map;
}

Image heat_map(const Image& a, const std::vector<float>& errors) {
    Image map = faint(a);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (errors[i] > 0.0f) paint(&map.rgb[3 * i], errors[i]);
    }
    return map;
}

}  // namespace pushfactor::renderer
