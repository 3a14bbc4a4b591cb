#include "demos/pictures/overlays/overlay.h"

#include "demos/pictures/overlays/acting.h"
#include "demos/pictures/overlays/outside.h"
#include "demos/pictures/overlays/thrust.h"
#include "demos/pictures/to_glm.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

namespace pushfactor::demos::pictures {

namespace {

using engine::Vector3;

void add_contacts(const std::vector<Acting>& acting, std::vector<Quantity>& found) {
    for (const Acting& at : acting) {
        const bool touches = at.kind == Acting::Kind::touching;
        if (!touches && at.kind != Acting::Kind::within_margin) continue;
        found.push_back({.place = at.place, .kind = touches ? 0u : 1u});
    }
}

// Legend entry of a force.
std::size_t entry_of(Acting::Kind kind) {
    return kind == Acting::Kind::joint ? 2 : kind == Acting::Kind::distance ? 1 : 0;
}

void add_forces(const std::vector<Acting>& acting, std::vector<Quantity>& found) {
    for (const Acting& at : acting) {
        found.push_back({.place = at.place, .value = at.force, .kind = entry_of(at.kind)});
    }
}

void add_push(const std::vector<Acting>& acting, std::vector<Quantity>& found) {
    for (const Acting& at : acting) {
        found.push_back({.place = at.place, .value = at.correcting, .kind = 0});
        found.push_back({.place = at.place, .value = at.lasting, .kind = 1});
    }
}

void add_velocities(const BuiltScene& scene, std::vector<Quantity>& found) {
    for (const engine::Body& body : scene.world.bodies) {
        if (!body.is_static()) found.push_back({.place = body.position, .value = velocity(body)});
    }
}

// Depends on the island's first body, so that an island keeps its colour while others come and go. Fifteen colours:
// the palette in three shades.
glm::vec3 colour_of_island(std::size_t first_body) {
    constexpr std::size_t colours = palette.size() - 1;  // ivory is for bodies in none
    const glm::vec3 colour = to_glm(palette[first_body % colours]);
    switch (first_body / colours % 3) {
        case 1:
            return glm::mix(colour, glm::vec3(1.0f), 0.45f);
        case 2:
            return 0.6f * colour;
        default:
            return colour;
    }
}

bool is_in_island(const BuiltScene& scene, std::size_t body) {
    return !scene.world.rows().empty() && scene.world.islands().of_body(static_cast<int>(body)) >= 0;
}

void add_islands(const BuiltScene& scene, std::vector<Quantity>& found) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!scene.bodies[i].mass) continue;
        found.push_back({.place = scene.world.bodies[i].position, .kind = is_in_island(scene, i) ? 0u : 1u});
    }
}

// Legend entry of a movable body.
std::size_t rest_of(const BuiltScene& scene, std::size_t body) {
    const auto index = static_cast<int>(body);
    if (scene.world.rest->is_at_rest(index)) return 0;
    return scene.world.rest->is_still(index) ? 1 : 2;
}

void add_rest(const BuiltScene& scene, std::vector<Quantity>& found) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!scene.bodies[i].mass) continue;
        found.push_back({.place = scene.world.bodies[i].position, .kind = rest_of(scene, i)});
    }
}

glm::vec3 island_colour_of(const BuiltScene& scene, std::size_t body) {
    if (!is_in_island(scene, body)) return to_glm(*find_colour(colour_of_none));
    const engine::Islands& islands = scene.world.islands();
    const auto island = static_cast<std::size_t>(islands.of_body(static_cast<int>(body)));
    return colour_of_island(static_cast<std::size_t>(islands.all()[island].bodies.front()));
}

glm::vec3 rest_colour_of(const BuiltScene& scene, std::size_t body) {
    return to_glm(entries_of(OverlayKind::rest)[rest_of(scene, body)].colour);
}

// Colours movable bodies with `colour_of`.
template <typename ColourOf>
void colour_bodies(const BuiltScene& scene, const ColourOf& colour_of, renderer::Picture& picture) {
    for (renderer::Body& body : picture.bodies) {
        if (scene.bodies[body.index].mass) body.colour = colour_of(scene, body.index);
    }
}

// Speed [m/s] below which a body stands still: what solves leave, by the default tolerance, and rounding.
constexpr double unsolved = 1e-8;

}  // namespace

std::vector<Quantity> quantities(const BuiltScene& scene, OverlayKind kind) {
    std::vector<Quantity> found;
    if (kind == OverlayKind::velocities) {
        add_velocities(scene, found);
        add_moved_velocities(scene, 1, found);
        for (Quantity& velocity : found) {
            if (velocity.value.norm() < unsolved) velocity.value.setZero();
        }
    }
    if (kind == OverlayKind::forces) add_applied_forces(scene, 3, found);
    if (kind == OverlayKind::torques) add_applied_torques(scene, 0, found);
    if (kind == OverlayKind::no_contacts) add_untouching(scene, 0, 1, found);
    if (kind == OverlayKind::islands) add_islands(scene, found);
    if (kind == OverlayKind::rest) add_rest(scene, found);
    if (!any_forces(scene)) return found;
    if (kind == OverlayKind::contacts) add_contacts(acting_in(scene), found);
    if (kind == OverlayKind::forces) add_forces(acting_in(scene), found);
    if (kind == OverlayKind::push) add_push(acting_in(scene), found);
    if (scene.contacts && kind == OverlayKind::thrust) {
        for (const PressureCentre& centre : pressure_centres(scene)) found.push_back({.place = centre.place});
    }
    if (scene.joints && kind == OverlayKind::torques) add_motor_torques(scene, 1, found);
    return found;
}

namespace {

// What an overlay needs and the scene lacks; empty if nothing.
std::string lack_of(const BuiltScene& scene, OverlayKind kind) {
    const bool has_rows = scene.contacts || scene.distances || scene.joints;
    switch (kind) {
        case OverlayKind::trails:
        case OverlayKind::velocities:
            return "";
        case OverlayKind::rest:
            return scene.world.rest ? "" : "nothing rests with --rest off or in RATTLE steps";
        case OverlayKind::torques: {
            const bool any_motor =
                scene.joints && std::ranges::any_of(scene.joints->joints(), [](const auto& joint) {
                    return joint.hinge && joint.hinge->motor;
                });
            return any_motor || !scene.pokes.empty() ? "" : "neither motors nor torques";
        }
        case OverlayKind::no_contacts: {
            const bool any_group =
                std::ranges::any_of(scene.bodies, [](const auto& body) { return !body.group.empty(); });
            return any_group || !scene.no_contacts.empty() ? "" : "no pairs that do not touch";
        }
        case OverlayKind::contacts:
        case OverlayKind::thrust:
            return scene.contacts ? "" : has_rows ? "no contacts" : "neither contacts nor distances";
        case OverlayKind::forces:
            return has_rows || !scene.pokes.empty() ? "" : "neither contacts nor distances";
        case OverlayKind::push:
        case OverlayKind::islands:
            return has_rows ? "" : "neither contacts nor distances";
    }
    return "";
}

}  // namespace

void require_shown(const BuiltScene& scene, const std::vector<OverlayItem>& overlay) {
    for (const OverlayItem& item : overlay) {
        const std::string lack = lack_of(scene, item.kind);
        if (lack.empty()) continue;
        if (item.kind == OverlayKind::rest) throw UsageError("--overlay rest: " + lack);
        throw UsageError(fmt::format("--overlay {}: scene {} has {}, so there is nothing to show",
                                     name_of(item.kind), scene.name, lack));
    }
}

void add_overlay(const BuiltScene& scene, OverlayKind kind, double units_a_metre, renderer::Picture& picture) {
    if (kind == OverlayKind::islands) return colour_bodies(scene, island_colour_of, picture);
    if (kind == OverlayKind::rest) return colour_bodies(scene, rest_colour_of, picture);
    const std::vector<LegendEntry> entries = entries_of(kind);
    for (const Quantity& quantity : quantities(scene, kind)) {
        const glm::vec3 colour = to_glm(entries[quantity.kind].colour);
        const glm::vec3 place = to_glm(quantity.place);
        if (kind == OverlayKind::contacts || kind == OverlayKind::thrust) {
            picture.dots.push_back({.position = place, .colour = colour});
        } else if (kind == OverlayKind::no_contacts) {
            const glm::vec3 end = to_glm(quantity.place + quantity.value);
            picture.arrows.push_back({.from = place, .to = end, .colour = colour, .head = false});
        } else {
            const glm::vec3 end = to_glm(quantity.place + quantity.value / units_a_metre);
            picture.arrows.push_back({.from = place, .to = end, .colour = colour});
        }
    }
    if (kind != OverlayKind::thrust || scene.world.rows().empty()) return;
    for (const auto& [from, to] : line_of_thrust(pressure_centres(scene), scene)) {
        picture.arrows.push_back(
            {.from = to_glm(from), .to = to_glm(to), .colour = to_glm(entries[0].colour), .head = false});
    }
}

}  // namespace pushfactor::demos::pictures
