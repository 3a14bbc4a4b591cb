// The options --camera and --overlay: from where a scene is seen, and quantities drawn over its bodies.
#pragma once

#include "demos/scenes/scene_description.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

// Without --camera the scene's own view is used, and of stills and comparisons a view that fits.
struct CameraChoice {
    std::string text{};             // as given; empty if not given
    std::optional<View> view{};     // of a camera file
    bool fit = false;               // about the same direction, as close as possible with all motion in view
    double degrees_a_second = 0.0;  // around the vertical through the target, counter-clockwise seen from above
};

// Parses "scene", "FILE", "fit", "orbit:DEGREES_PER_SECOND" or several of them separated by commas. None for other
// text; throws UsageError for a file that is not a camera.
std::optional<CameraChoice> parse_camera(std::string_view text);

// `view` after orbiting for `time` [s].
View turned(const CameraChoice& choice, View view, double time);

enum class OverlayKind {
    contacts,  // the contact points
    forces,  // N, of contacts with their friction, of distances and joints, as they enter the momenta; from outside
    torques,      // N m, from outside and of motors, along their axes
    push,         // m/s, the push factors of contacts and distances
    velocities,   // m/s, of the centres of mass, from the stored momenta; of moved bodies also around their axes
    islands,      // colours of the bodies: one per island
    rest,         // colours of the bodies: at rest, still, or moving (which keeps their island awake)
    no_contacts,  // lines between bodies that do not touch each other
    thrust,       // centres of pressure of touching pairs, joined within bodies that have two: the line of thrust
    trails,       // paths of the centres of bodies that move, over the last seconds
};

struct OverlayItem {
    OverlayKind kind = OverlayKind::contacts;
    std::optional<double> units_a_metre{};  // N or m/s per metre of arrow; chosen for the run if not given
    std::optional<double> seconds{};        // of trails
};

// Parses "forces,velocities" or, with a number, "forces:50" for 50 N per metre or "trails:0.5" for half a second.
// None for other text.
std::optional<std::vector<OverlayItem>> parse_overlay(std::string_view text);
std::string to_text(const std::vector<OverlayItem>& overlay);
std::string_view name_of(OverlayKind kind);

// Whether the overlay colours the bodies.
inline bool colours_bodies(OverlayKind kind) {
    return kind == OverlayKind::islands || kind == OverlayKind::rest;
}

// Whether replays have the overlay.
inline bool is_in_replays(OverlayKind kind) {
    return kind == OverlayKind::contacts || kind == OverlayKind::forces || kind == OverlayKind::push ||
           kind == OverlayKind::velocities;
}

// Whether the overlay has arrows, and so a scale.
inline bool has_arrows(OverlayKind kind) {
    return kind != OverlayKind::contacts && kind != OverlayKind::thrust && kind != OverlayKind::no_contacts &&
           kind != OverlayKind::trails && !colours_bodies(kind);
}

}  // namespace pushfactor::demos
