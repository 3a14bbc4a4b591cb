#include "demos/options/overlay_choice.h"

#include "demos/text/comma_list.h"
#include "demos/text/numbers.h"

#include <array>

namespace pushfactor::demos {

namespace {

constexpr std::array<std::string_view, 10> names{"contacts", "forces", "torques",     "push",   "velocities",
                                                 "islands",  "rest",   "no-contacts", "thrust", "trails"};

// Of what follows a colon: pictures have single precision.
constexpr double least = 1e-12, most = 1e12;

}  // namespace

std::string_view name_of(OverlayKind kind) {
    return names[static_cast<std::size_t>(kind)];
}

std::optional<std::vector<OverlayItem>> parse_overlay(std::string_view text) {
    std::vector<OverlayItem> overlay;
    for (const std::string_view part : parts_of(text)) {
        const std::size_t colon = part.find(':');
        const auto found = std::find(names.begin(), names.end(), part.substr(0, colon));
        if (found == names.end()) return std::nullopt;
        OverlayItem item{.kind = static_cast<OverlayKind>(found - names.begin())};
        if (colon != std::string_view::npos) {
            const bool trails = item.kind == OverlayKind::trails;
            std::optional<double>& number = trails ? item.seconds : item.units_a_metre;
            number = parse_number(part.substr(colon + 1));
            if (!(trails || has_arrows(item.kind)) || !number || *number < least || *number > most)
                return std::nullopt;
        }
        const bool twice = std::any_of(overlay.begin(), overlay.end(), [&](const OverlayItem& other) {
            return other.kind == item.kind || (colours_bodies(other.kind) && colours_bodies(item.kind));
        });
        if (twice) return std::nullopt;
        overlay.push_back(item);
    }
    return overlay;
}

std::string to_text(const std::vector<OverlayItem>& overlay) {
    std::string text;
    for (const OverlayItem& item : overlay) {
        text += (text.empty() ? "" : ",") + std::string(name_of(item.kind));
        if (item.units_a_metre) text += ":" + to_text(*item.units_a_metre);
        if (item.seconds) text += ":" + to_text(*item.seconds);
    }
    return text;
}

}  // namespace pushfactor::demos
