#include "demos/pictures/overlays/scale.h"

#include "demos/pictures/camera/framing.h"

#include <fmt/format.h>

#include <cmath>

namespace pushfactor::demos::pictures {

namespace {

// 1, 2 or 5 times a power of ten, at most `value`.
double round_number(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double digit = value / power;
    return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

}  // namespace

std::vector<Scale> scales_of(const std::vector<OverlayItem>& overlay, const Survey& survey, const View& view) {
    std::vector<Scale> scales;
    for (const OverlayItem& item : overlay) {
        const auto typical = survey.typical.find(item.kind);
        const double usual = typical == survey.typical.end() ? 1.0 : typical->second;
        const double chosen = usual / (typical_arrow * distance_of(view));
        scales.push_back({item.kind, item.units_a_metre.value_or(chosen)});
    }
    return scales;
}

LegendLine legend_line(const LegendEntry& entry, const Scale& scale, const View& view, int height) {
    if (entry.unit.empty()) return {.colour = entry.colour, .text = entry.name};
    const double example = round_number(1.3 * typical_arrow * distance_of(view) * scale.units_a_metre);
    const double pixels_a_metre = 0.5 * height / (distance_of(view) * half_tangent(view));
    return {.colour = entry.colour,
            .text = fmt::format("{}, {:g} {}", entry.name, example, entry.unit),
            .arrow = static_cast<float>(example / scale.units_a_metre * pixels_a_metre)};
}

}  // namespace pushfactor::demos::pictures
