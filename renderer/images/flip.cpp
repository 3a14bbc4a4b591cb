#include "renderer/images/flip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace pushfactor::renderer {

namespace {

using Colour = std::array<float, 3>;

// One channel of an image.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    float& at(int x, int y) { return values[static_cast<std::size_t>(y * width + x)]; }
    float at(int x, int y) const { return values[static_cast<std::size_t>(y * width + x)]; }
};

using Planes = std::array<Plane, 3>;

// Weights of the pixels at -radius .. radius.
using Kernel = std::vector<float>;

float linear(std::uint8_t level) {
    const float value = static_cast<float>(level) / 255.0f;
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

// sRGB primaries and D65, as matrices of linear RGB.
constexpr std::array<Colour, 3> to_xyz{
    {{10135552.0f / 24577794.0f, 8788810.0f / 24577794.0f, 4435075.0f / 24577794.0f},
     {2613072.0f / 12288897.0f, 8788810.0f / 12288897.0f, 887015.0f / 12288897.0f},
     {1425312.0f / 73733382.0f, 8788810.0f / 73733382.0f, 70074185.0f / 73733382.0f}}};
constexpr std::array<Colour, 3> from_xyz{{{3.241003232976358f, -1.537398969488785f, -0.498615881996363f},
                                          {-0.969224252202516f, 1.875929983695176f, 0.041554226340085f},
                                          {0.055639419851975f, -0.204011206123910f, 1.057148977187533f}}};

Colour times(const std::array<Colour, 3>& matrix, const Colour& colour) {
    Colour result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = matrix[i][0] * colour[0] + matrix[i][1] * colour[1] + matrix[i][2] * colour[2];
    }
    return result;
}

// XYZ relative to that of white.
Colour relative_xyz(const Colour& rgb) {
    Colour xyz = times(to_xyz, rgb);
    const Colour white = times(to_xyz, {1.0f, 1.0f, 1.0f});
    for (std::size_t i = 0; i < 3; ++i) xyz[i] /= white[i];
    return xyz;
}

// A linear opponent space: luminance, red-green, blue-yellow.
Colour opponent(const Colour& rgb) {
    const Colour xyz = relative_xyz(rgb);
    return {116.0f * xyz[1] - 16.0f, 500.0f * (xyz[0] - xyz[1]), 200.0f * (xyz[1] - xyz[2])};
}

Colour from_opponent(const Colour& colour) {
    const float y = (colour[0] + 16.0f) / 116.0f;
    const Colour white = times(to_xyz, {1.0f, 1.0f, 1.0f});
    Colour rgb =
        times(from_xyz, {(y + colour[1] / 500.0f) * white[0], y * white[1], (y - colour[2] / 200.0f) * white[2]});
    for (float& value : rgb) value = std::clamp(value, 0.0f, 1.0f);
    return rgb;
}

// L*a*b*, with the chroma that is seen at that luminance (Hunt).
Colour seen_colour(const Colour& rgb) {
    constexpr float delta = 6.0f / 29.0f;
    Colour f = relative_xyz(rgb);
    for (float& value : f) {
        value = value > delta * delta * delta ? std::cbrt(value) : value / (3.0f * delta * delta) + 4.0f / 29.0f;
    }
    const float luminance = 116.0f * f[1] - 16.0f;
    return {luminance, 0.01f * luminance * 500.0f * (f[0] - f[1]), 0.01f * luminance * 200.0f * (f[1] - f[2])};
}

// City-block distance in luminance, Euclidean in chroma.
float distance(const Colour& a, const Colour& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

Planes opponent_planes(const Image& image) {
    std::array<float, 256> table;
    for (std::size_t i = 0; i < 256; ++i) table[i] = linear(static_cast<std::uint8_t>(i));
    Planes planes{Plane(image.width, image.height), Plane(image.width, image.height),
                  Plane(image.width, image.height)};
    for (std::size_t i = 0; i < planes[0].values.size(); ++i) {
        const Colour colour =
            opponent({table[image.rgb[3 * i]], table[image.rgb[3 * i + 1]], table[image.rgb[3 * i + 2]]});
        for (std::size_t k = 0; k < 3; ++k) planes[k].values[i] = colour[k];
    }
    return planes;
}

// Filters along rows, then along columns; beyond the border the outermost pixel is repeated.
Plane filtered(const Plane& plane, const Kernel& across, const Kernel& down) {
    const int radius = static_cast<int>(across.size() / 2);
    Plane rows(plane.width, plane.height), result(plane.width, plane.height);
    for (int y = 0; y < plane.height; ++y) {
        for (int x = 0; x < plane.width; ++x) {
            float sum = 0.0f;
            for (int k = -radius; k <= radius; ++k) {
                sum += across[static_cast<std::size_t>(k + radius)] *
                       plane.at(std::clamp(x + k, 0, plane.width - 1), y);
            }
            rows.at(x, y) = sum;
        }
    }
    for (int y = 0; y < plane.height; ++y) {
        for (int k = -radius; k <= radius; ++k) {
            const float weight = down[static_cast<std::size_t>(k + radius)];
            const int from = std::clamp(y + k, 0, plane.height - 1);
            for (int x = 0; x < plane.width; ++x) result.at(x, y) += weight * rows.at(x, from);
        }
    }
    return result;
}

// exp(-pi^2 x^2 / b), x in degrees.
Kernel gaussian(float b, int radius, float pixels_per_degree) {
    constexpr float pi = std::numbers::pi_v<float>;
    Kernel kernel;
    for (int k = -radius; k <= radius; ++k) {
        const float x = static_cast<float>(k) / pixels_per_degree;
        kernel.push_back(std::exp(-pi * pi * x * x / b));
    }
    return kernel;
}

float sum_of(const Kernel& kernel) {
    float sum = 0.0f;
    for (const float weight : kernel) sum += weight;
    return sum;
}

// Contrast sensitivity of a channel: the sum of two Gaussians a sqrt(pi / b) exp(-pi^2 x^2 / b) (table 1).
struct Sensitivity {
    float a1, b1, a2, b2;
};
constexpr std::array sensitivities{Sensitivity{1.0f, 0.0047f, 0.0f, 1e-5f}, Sensitivity{1.0f, 0.0053f, 0.0f, 1e-5f},
                                   Sensitivity{34.1f, 0.04f, 13.5f, 0.025f}};

Plane seen(const Plane& plane, const Sensitivity& sensitivity, int radius, float pixels_per_degree) {
    const auto scaled = [](float a, float b) { return a * std::sqrt(std::numbers::pi_v<float> / b); };
    const Kernel first = gaussian(sensitivity.b1, radius, pixels_per_degree);
    const float weight_1 = scaled(sensitivity.a1, sensitivity.b1) * sum_of(first) * sum_of(first);
    Plane result = filtered(plane, first, first);
    if (sensitivity.a2 == 0.0f) {
        for (float& value : result.values) value /= sum_of(first) * sum_of(first);
        return result;
    }
    const Kernel second = gaussian(sensitivity.b2, radius, pixels_per_degree);
    const float weight_2 = scaled(sensitivity.a2, sensitivity.b2) * sum_of(second) * sum_of(second);
    const Plane other = filtered(plane, second, second);
    const float one = scaled(sensitivity.a1, sensitivity.b1) / (weight_1 + weight_2);
    const float two = scaled(sensitivity.a2, sensitivity.b2) / (weight_1 + weight_2);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        result.values[i] = one * result.values[i] + two * other.values[i];
    }
    return result;
}

// Colours as seen from the distance of the viewer.
std::vector<Colour> seen_colours(const Planes& planes, float pixels_per_degree) {
    constexpr float pi = std::numbers::pi_v<float>;
    const int radius = static_cast<int>(std::ceil(3.0f * std::sqrt(0.04f / (2.0f * pi * pi)) * pixels_per_degree));
    Planes blurred = planes;
    for (std::size_t k = 0; k < 3; ++k) blurred[k] = seen(planes[k], sensitivities[k], radius, pixels_per_degree);
    std::vector<Colour> colours(planes[0].values.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        colours[i] = seen_colour(from_opponent({blurred[0].values[i], blurred[1].values[i], blurred[2].values[i]}));
    }
    return colours;
}

// Compresses large colour differences: 0..1, and 0.95 at 0.4 of the largest.
class ColourError {
  public:
    ColourError() : largest_(std::pow(distance(seen_colour({0, 1, 0}), seen_colour({0, 0, 1})), exponent)) {}

    float operator()(const Colour& a, const Colour& b) const {
        const float error = std::pow(distance(a, b), exponent);
        const float knee = 0.4f * largest_;
        if (error < knee) return 0.95f * error / knee;
        return 0.95f + 0.05f * (error - knee) / (largest_ - knee);
    }

  private:
    static constexpr float exponent = 0.7f;
    float largest_;
};

// Positive weights are scaled to a sum of 1, negative ones to -1.
void balance(Kernel& kernel) {
    float positive = 0.0f, negative = 0.0f;
    for (const float weight : kernel) (weight > 0.0f ? positive : negative) += weight;
    for (float& weight : kernel) weight /= weight > 0.0f ? positive : -negative;
}

// Strength of edges or of points, by a derivative of a Gaussian that is as wide as what the eye resolves.
std::vector<float> strength(const Plane& luminance, const Kernel& derivative, const Kernel& smooth) {
    const Plane across = filtered(luminance, derivative, smooth), down = filtered(luminance, smooth, derivative);
    std::vector<float> result(across.values.size());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = std::hypot(across.values[i], down.values[i]);
    return result;
}

struct Features {
    std::vector<float> edges, points;
};

Features features_of(const Planes& planes, float pixels_per_degree) {
    Plane luminance = planes[0];
    for (float& value : luminance.values) value = (value + 16.0f) / 116.0f;
    constexpr float width = 0.082f;  // degrees
    const float deviation = 0.5f * width * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3.0f * deviation));
    Kernel smooth, edge, point;
    for (int k = -radius; k <= radius; ++k) {
        const float x = static_cast<float>(k), weight = std::exp(-x * x / (2.0f * deviation * deviation));
        smooth.push_back(weight);
        edge.push_back(-x * weight);
        point.push_back((x * x / (deviation * deviation) - 1.0f) * weight);
    }
    const float sum = sum_of(smooth);
    for (float& weight : smooth) weight /= sum;
    balance(edge);
    balance(point);
    return {strength(luminance, edge, smooth), strength(luminance, point, smooth)};
}

}  // namespace

std::vector<float> flip(const Image& expected, const Image& actual, float pixels_per_degree) {
    assert(expected.width == actual.width && expected.height == actual.height);
    const Planes a = opponent_planes(expected), b = opponent_planes(actual);
    const std::vector<Colour> colours_a = seen_colours(a, pixels_per_degree),
                              colours_b = seen_colours(b, pixels_per_degree);
    const Features features_a = features_of(a, pixels_per_degree), features_b = features_of(b, pixels_per_degree);
    const ColourError colour_error;
    std::vector<float> errors(colours_a.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const float feature = std::max(std::abs(features_a.edges[i] - features_b.edges[i]),
                                       std::abs(features_a.points[i] - features_b.points[i]));
        const float feature_error = std::sqrt(std::clamp(feature / std::numbers::sqrt2_v<float>, 0.0f, 1.0f));
        errors[i] = std::pow(colour_error(colours_a[i], colours_b[i]), 1.0f - feature_error);
    }
    return errors;
}

}  // namespace pushfactor::renderer
