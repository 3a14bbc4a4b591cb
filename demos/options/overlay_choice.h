// What is drawn over the bodies to show what is behind their motion.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

enum class OverlayKind {
    contacts,    // the contact points
    forces,      // N, of contacts with their friction and of distances, as they enter the momenta
    push,        // m/s, the push factors of contacts and distances
    velocities,  // m/s, of the centres of mass, from the stored momenta
    islands,     // the bodies themselves, one colour per island
    rest,        // the bodies themselves: at rest, still, or what keeps its island from it
};

struct OverlayItem {
    OverlayKind kind = OverlayKind::contacts;
    std::optional<double> units_a_metre{};  // how long an arrow is drawn; chosen to suit the run when not given
};

// "forces,velocities" or, with a scale, "forces:50" for 50 N per metre. Nothing when the text is none of that.
std::optional<std::vector<OverlayItem>> parse_overlay(std::string_view text);
std::string to_text(const std::vector<OverlayItem>& overlay);
std::string_view name_of(OverlayKind kind);

// Whether it is a colour of the bodies themselves.
inline bool colours_bodies(OverlayKind kind) {
    return kind == OverlayKind::islands || kind == OverlayKind::rest;
}

// Whether it has arrows, which have a scale.
inline bool has_arrows(OverlayKind kind) {
    return kind != OverlayKind::contacts && !colours_bodies(kind);
}

}  // namespace pushfactor::demos
