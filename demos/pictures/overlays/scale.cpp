#include "demos/pictures/overlays/scale.h"

namespace pushfactor::demos::pictures {

std::vector<Scale> scales_of(const std::vector<OverlayItem>& overlay, const Survey& survey, const View& view) {
    std::vector<Scale> scales;
    for (const OverlayItem& item : overlay) {
        const auto typical = survey.typical.find(item.kind);
        const double usual = typical == survey.typical.end() ? 1.0 : typical->second;
        const double chosen = usual / (typical_arrow * (view.target - view.eye).norm());
        scales.push_back({item.kind, item.units_a_metre.value_or(chosen)});
    }
    return scales;
}

}  // namespace pushfactor::demos::pictures
