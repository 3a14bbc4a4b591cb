#include "demos/pictures/overlays/overlay.h"

#include "demos/base/text/errors.h"
#include "demos/pictures/overlays/acting.h"
#include "demos/pictures/to_glm.h"
#include "engine/base/index.h"

#include <map>

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

// Legend entry of a movable body that the overlay colours.
std::size_t entry_of_body(const BuiltScene& scene, OverlayKind kind, std::size_t body) {
    const auto index = static_cast<int>(body);
    if (kind == OverlayKind::islands) {
        return !scene.world.rows().empty() && scene.world.islands().of_body(index) >= 0 ? 0 : 1;
    }
    return scene.world.rest->is_at_rest(index) ? 0 : scene.world.rest->is_still(index) ? 1 : 2;
}

glm::vec3 colour_of_body(const BuiltScene& scene, OverlayKind kind, std::size_t body) {
    const std::size_t entry = entry_of_body(scene, kind, body);
    if (kind == OverlayKind::rest || entry == 1) return to_glm(entries_of(kind)[entry].colour);
    const engine::Islands& islands = scene.world.islands();
    const std::size_t island = engine::at(islands.of_body(static_cast<int>(body)));
    return colour_of_island(engine::at(islands.all()[island].bodies.front()));
}

bool has_row_of(const engine::World& world, std::size_t row, std::size_t joint) {
    const engine::RowLabel& label = world.rows()[row].label;
    return label.kind == engine::RowKind::joint && label.point == static_cast<int>(joint);
}

// Torques on single bodies as they are now, at the centres of mass, and of motors in the last step, along their
// axes on the bodies that they turn, at the hinges.
std::vector<Quantity> torques_in(const BuiltScene& scene) {
    const engine::World& world = scene.world;
    std::vector<Quantity> found;
    for (const engine::PokeForce* const source : scene.pokes) {
        if (!source->acts_at(world.time())) continue;
        const engine::Body& body = world.bodies[engine::at(source->poke().body)];
        const Vector3 torque = source->torque(body.orientation);
        if (!torque.isZero(0.0)) found.push_back({.place = body.position, .value = torque, .kind = 0});
    }
    if (!scene.joints || !any_forces(scene)) return found;
    std::size_t row = 0;
    for (const std::size_t acting : scene.joints->acting()) {
        const engine::Joint& joint = scene.joints->joints()[acting];
        while (!has_row_of(world, row, acting)) ++row;
        if (!joint.hinge || !joint.hinge->motor) continue;
        // The row of a motor is L [0, -u, 0, u], zero for a static body: its force times that is its torque.
        const std::size_t motor = row + engine::motor_row;
        const bool b_turns = !world.bodies[engine::at(joint.body_b)].is_static();
        const engine::Jacobian& jacobian = world.rows()[motor].jacobian;
        const Vector3 torque = lasting_force(world, motor) * (b_turns ? jacobian.b : jacobian.a).tail<3>();
        found.push_back({.place = span_of(joint, world.bodies).to, .value = torque, .kind = 1});
    }
    return found;
}

// Of moved bodies the mean in the last step: of the centre, and of four points around the axis of one that turns.
std::vector<Quantity> velocities_in(const BuiltScene& scene) {
    // Speed [m/s] below which a body stands still: what solves leave, by the default tolerance, and rounding.
    constexpr double unsolved = 1e-8;
    std::vector<Quantity> found;
    for (const engine::Body& body : scene.world.bodies) {
        if (!body.is_static()) found.push_back({.place = body.position, .value = velocity(body)});
    }
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const engine::Body& body = scene.world.bodies[i];
        if (!body.is_moved()) continue;
        const engine::Motion& motion = body.prescribed;
        found.push_back({.place = body.position, .value = motion.velocity, .kind = 1});
        if (motion.angular_velocity.isZero(0.0)) continue;
        const bool plane = std::holds_alternative<PlaneShape>(scene.bodies[i].shape);
        const double reach = plane ? 1.0 : bounding_radius(scene.bodies[i]);  // m
        const Vector3 u = reach * motion.angular_velocity.unitOrthogonal();
        const Vector3 v = motion.angular_velocity.normalized().cross(u);
        for (const Vector3& arm : {u, v, Vector3(-u), Vector3(-v)}) {
            const Vector3 velocity = motion.velocity + motion.angular_velocity.cross(arm);
            found.push_back({.place = body.position + arm, .value = velocity, .kind = 1});
        }
    }
    for (Quantity& velocity : found) {
        if (velocity.value.norm() < unsolved) velocity.value.setZero();
    }
    return found;
}

// Lines between bodies that do not touch each other, from `place` by `value`: one per pair, and one from each body
// of a group to the middle of the group.
std::vector<Quantity> untouching_in(const BuiltScene& scene) {
    std::vector<Quantity> found;
    const auto& bodies = scene.world.bodies;
    for (const engine::collision::Pair& pair : scene.no_contacts) {
        const Vector3 from = bodies[engine::at(pair.a)].position;
        const Vector3 to = bodies[engine::at(pair.b)].position;
        found.push_back({.place = from, .value = to - from, .kind = 0});
    }
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!scene.bodies[i].group.empty()) groups[scene.bodies[i].group].push_back(i);
    }
    for (const auto& [name, members] : groups) {
        Vector3 middle = Vector3::Zero();
        for (const std::size_t member : members) middle += bodies[member].position;
        middle /= static_cast<double>(members.size());
        for (const std::size_t member : members) {
            const Vector3& from = bodies[member].position;
            found.push_back({.place = from, .value = middle - from, .kind = 1});
        }
    }
    return found;
}

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

std::vector<LegendEntry> entries_of(OverlayKind kind) {
    const auto colour = [](std::string_view name) { return *find_colour(name); };
    switch (kind) {
        case OverlayKind::contacts:
            return {{"contact point", colour("vermilion"), ""}, {"within the margin", colour("ivory"), ""}};
        case OverlayKind::forces:
            return {{"contact force", colour("violet"), "N"},
                    {"force of a bar or spring", colour("green"), "N"},
                    {"joint force", colour("orange"), "N"},
                    {"force from outside", colour("blue"), "N"}};
        case OverlayKind::torques:
            return {{"torque from outside", colour("blue"), "N m"},
                    {"torque of a motor", colour("vermilion"), "N m"}};
        case OverlayKind::push:
            return {{"push for this frame only", colour("orange"), "m/s"},
                    {"push that lasts", colour("vermilion"), "m/s"}};
        case OverlayKind::islands:
            return {{"one colour per island", colour("vermilion"), ""},
                    {"in no island", colour(colour_of_none), ""}};
        case OverlayKind::rest:
            return {{"at rest", colour("green"), ""},
                    {"still, but held by what is not", colour(colour_of_none), ""},
                    {"moves, or did a moment ago", colour("vermilion"), ""}};
        case OverlayKind::thrust:
            return {{"line of thrust, through the centres of pressure", colour("violet"), ""}};
        case OverlayKind::no_contacts:
            return {{"do not touch each other", colour("vermilion"), ""},
                    {"one group, whose bodies do not touch", colour("blue"), ""}};
        case OverlayKind::trails:
            return {{"path of a centre, in its colour", colour(colour_of_none), ""}};
        case OverlayKind::velocities:
            break;
    }
    return {{"velocity", colour("blue"), "m/s"}, {"of a moved body", colour("orange"), "m/s"}};
}

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
            return torques_in(scene);
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
            return untouching_in(scene);
        case OverlayKind::thrust:
            if (!scene.contacts || !any_forces(scene)) break;
            for (const PressureCentre& centre : pressure_centres(scene)) add(centre.place, Vector3::Zero(), 0);
            break;
        case OverlayKind::trails:
            break;
    }
    return found;
}

void require_shown(const BuiltScene& scene, const std::vector<OverlayItem>& overlay) {
    for (const OverlayItem& item : overlay) {
        const std::string lack = lack_of(scene, item.kind);
        if (lack.empty()) continue;
        if (item.kind == OverlayKind::rest) throw UsageError("--overlay rest: " + lack);
        throw UsageError("--overlay {}: scene {} has {}, so there is nothing to show", name_of(item.kind),
                         scene.name, lack);
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
    if (kind != OverlayKind::thrust || !scene.contacts || !any_forces(scene)) return;
    for (const auto& [from, to] : line_of_thrust(pressure_centres(scene), scene)) {
        picture.arrows.push_back(
            {.from = to_glm(from), .to = to_glm(to), .colour = to_glm(entries[0].colour), .head = false});
    }
}

}  // namespace pushfactor::demos::pictures
