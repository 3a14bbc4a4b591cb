#include "demos/options/look_choices.h"

#include "demos/base/text/numbers.h"
#include "demos/scenes/scene_file.h"

#include <array>
#include <numbers>
#include <utility>

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
        const auto found = std::ranges::find(names, part.substr(0, colon));
        if (found == names.end()) return std::nullopt;
        OverlayItem item{.kind = static_cast<OverlayKind>(found - names.begin())};
        if (colon != std::string_view::npos) {
            const bool trails = item.kind == OverlayKind::trails;
            std::optional<double>& number = trails ? item.seconds : item.units_a_metre;
            number = parse_number(part.substr(colon + 1), least, most);
            if (!(trails || has_arrows(item.kind)) || !number) return std::nullopt;
        }
        const bool twice = std::ranges::any_of(overlay, [&](const OverlayItem& other) {
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

std::optional<CameraChoice> parse_camera(std::string_view text) {
    constexpr std::string_view orbit = "orbit:";
    CameraChoice choice{.text = std::string(text)};
    bool has_view = false, turns = false;
    for (const std::string_view part : parts_of(text)) {
        const bool is_orbit = part.starts_with(orbit);
        bool& given = part == "fit" ? choice.fit : is_orbit ? turns : has_view;
        if (std::exchange(given, true)) return std::nullopt;
        if (is_orbit) {
            const auto speed = parse_number(part.substr(orbit.size()), -1e4, 1e4);
            if (!speed) return std::nullopt;
            choice.degrees_a_second = *speed;
        } else if (part != "fit" && part != "scene") {
            if (!part.ends_with(".json") && !std::filesystem::is_regular_file(part)) return std::nullopt;
            choice.view = read_camera_file(part);
        }
    }
    return choice;
}

View turned(const CameraChoice& choice, View view, double time) {
    const double angle = choice.degrees_a_second * time * std::numbers::pi / 180.0;
    const engine::Quaternion turn = engine::exponential(angle * engine::Vector3::UnitY());
    if (angle != 0.0) view.eye = view.target + turn * (view.eye - view.target);
    return view;
}

}  // namespace pushfactor::demos
