#include "demos/options/camera_choice.h"

#include "demos/scenes/camera_file.h"
#include "demos/text/comma_list.h"
#include "demos/text/numbers.h"

#include <numbers>
#include <utility>

namespace pushfactor::demos {

std::optional<CameraChoice> parse_camera(std::string_view text) {
    constexpr std::string_view orbit = "orbit:";
    CameraChoice choice{.text = std::string(text)};
    bool has_view = false, turns = false;
    for (const std::string_view part : parts_of(text)) {
        const bool is_orbit = part.starts_with(orbit);
        bool& given = part == "fit" ? choice.fit : is_orbit ? turns : has_view;
        if (std::exchange(given, true)) return std::nullopt;
        if (is_orbit) {
            const auto speed = parse_number(part.substr(orbit.size()));
            if (!speed || std::abs(*speed) > 1e4) return std::nullopt;
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
