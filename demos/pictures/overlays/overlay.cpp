#include "demos/pictures/overlays/overlay.h"

#include "demos/pictures/overlays/acting.h"
#include "demos/pictures/overlays/outside.h"
#include "demos/pictures/to_glm.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

namespace pushfactor::demos::pictures {

namespace {

using engine::Vector3;

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

// Legend entry of a movable body that the overlay colours.
std::size_t entry_of_body(const BuiltScene& scene, OverlayKind kind, std::size_t body) {
    if (kind == OverlayKind::islands) return is_in_island(scene, body) ? 0 : 1;
    const auto index = static_cast<int>(body);
    return scene.world.rest->is_at_rest(index) ? 0 : scene.world.rest->is_still(index) ? 1 : 2;
}

glm::vec3 colour_of_body(const BuiltScene& scene, OverlayKind kind, std::size_t body) {
    const std::size_t entry = entry_of_body(scene, kind, body);
    if (kind == OverlayKind::rest || entry == 1) return to_glm(entries_of(kind)[entry].colour);
    const engine::Islands& islands = scene.world.islands();
    const auto island = static_cast<std::size_t>(islands.of_body(static_cast<int>(body)));
    return colour_of_island(static_cast<std::size_t>(islands.all()[island].bodies.front()));
}

// Speed [m/s] below which a body stands still: what solves leave, by the default tolerance, and rounding.
constexpr double unsolved = 1e-8;

std::vector<Quantity> velocities_in(const BuiltScene& scene) {
    std::vector<Quantity> found;
    for (const engine::Body& body : scene.world.bodies) {
        if (!body.is_static()) found.push_back({.place = body.position, .value = velocity(body)});
    }
    add_moved_velocities(scene, 1, found);
    for (Quantity& velocity : found) {
        if (velocity.value.norm() < unsolved) velocity.value.setZero();
    }
    return found;
}

}  // namespace

std::vector<Quantity> quantities(const BuiltScene& scene, OverlayKind kind) {
    using Kind = Acting::Kind;
    std::vector<Quantity> found;
    const auto add = [&](const Vector3& place, const Vector3& value, std::size_t entry) {
        found.push_back({.place = place, .value = value, .kind = entry});
    };
    switch (kind) {
        case OverlayKind::contacts:
            for (const Acting& at : acting_in(scene)) {
                if (at.kind == Kind::touching) add(at.place, Vector3::Zero(), 0);
                if (at.kind == Kind::within_margin) add(at.place, Vector3::Zero(), 1);
            }
            break;
        case OverlayKind::forces:
            for (const Acting& at : applied_in(scene)) add(at.place, at.force, 3);
            for (const Acting& at : acting_in(scene)) {
                add(at.place, at.force, at.kind == Kind::joint ? 2 : at.kind == Kind::distance ? 1 : 0);
            }
            break;
        case OverlayKind::torques:
            add_applied_torques(scene, 0, found);
            if (scene.joints && any_forces(scene)) add_motor_torques(scene, 1, found);
            break;
        case OverlayKind::push:
            for (const Acting& at : acting_in(scene)) {
                add(at.place, at.correcting, 0);
                add(at.place, at.lasting, 1);
            }
            break;
        case OverlayKind::velocities:
            return velocities_in(scene);
        case OverlayKind::islands:
        case OverlayKind::rest:
            for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
                if (!scene.bodies[i].mass) continue;
                add(scene.world.bodies[i].position, Vector3::Zero(), entry_of_body(scene, kind, i));
            }
            break;
        case OverlayKind::no_contacts:
            add_untouching(scene, 0, 1, found);
            break;
        case OverlayKind::thrust:
            if (!scene.contacts || !any_forces(scene)) break;
            for (const PressureCentre& centre : pressure_centres(scene)) add(centre.place, Vector3::Zero(), 0);
            break;
        case OverlayKind::trails:
            break;
    }
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
    if (colours_bodies(kind)) {
        for (renderer::Body& body : picture.bodies) {
            if (scene.bodies[body.index].mass) body.colour = colour_of_body(scene, kind, body.index);
        }
        return;
    }
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
