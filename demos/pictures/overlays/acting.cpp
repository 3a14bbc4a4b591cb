#include "demos/pictures/overlays/acting.h"

namespace pushfactor::demos::pictures {

namespace {

using engine::Vector3;

// The solution of one row.
struct RowAnswer {
    const engine::ConstraintRow& row;
    double lasting_force;  // N, acts on the momenta
};

RowAnswer answer_of(const engine::World& world, std::size_t row) {
    const auto& lambda = world.lambda();
    return {world.rows()[row], lambda(static_cast<Eigen::Index>(row), lambda.cols() - 1)};
}

bool is_static(const engine::World& world, int body) {
    return world.bodies[static_cast<std::size_t>(body)].is_static();
}

// Body of a contact that its force is drawn on: 1 for b, -1 for a.
double drawn_on(const engine::ContactSite& site, const engine::World& world) {
    if (is_static(world, site.body_a)) return 1.0;
    if (is_static(world, site.body_b)) return -1.0;
    return site.normal.y() >= 0.0 ? 1.0 : -1.0;
}

void add_contacts(const BuiltScene& scene, std::vector<Acting>& found) {
    for (const engine::ContactSite& site : scene.contacts->sites()) {
        const double side = drawn_on(site, scene.world);
        const auto& [row, normal_force] = answer_of(scene.world, site.normal_row);
        Vector3 force = site.normal * normal_force;
        for (std::size_t t = 0; site.friction_row && t < 2; ++t) {
            force += site.tangents[t] * answer_of(scene.world, *site.friction_row + t).lasting_force;
        }
        const Vector3 outwards = side * site.normal;
        found.push_back({.kind = row.label.gap > 0.0 ? Acting::Kind::within_margin : Acting::Kind::touching,
                         .body = side > 0.0 ? site.body_b : site.body_a,
                         .other = side > 0.0 ? site.body_a : site.body_b,
                         .place = site.position,
                         .force = side * force,
                         .correcting = row.push.correcting * outwards,
                         .lasting = row.push.lasting * outwards});
    }
}

// Adds the movable ends of something between two bodies whose point has the given rows: one along the span, or
// three along the world's axes.
void add_ends(const engine::World& world, Acting::Kind kind, int body_a, int body_b, const engine::Span& span,
              std::size_t first_row, bool along_axes, std::vector<Acting>& found) {
    const auto vector_of = [&](const auto& number_of) {
        if (!along_axes) return Vector3(number_of(first_row) * (span.to - span.from).normalized());
        return Vector3(number_of(first_row), number_of(first_row + 1), number_of(first_row + 2));
    };
    Acting end{.kind = kind,
               .body = body_b,
               .other = body_a,
               .place = span.to,
               .force = vector_of([&](std::size_t row) { return answer_of(world, row).lasting_force; }),
               .correcting = vector_of([&](std::size_t row) { return world.rows()[row].push.correcting; }),
               .lasting = vector_of([&](std::size_t row) { return world.rows()[row].push.lasting; })};
    if (!is_static(world, body_a)) {
        found.push_back({.kind = kind,
                         .body = body_a,
                         .other = body_b,
                         .place = span.from,
                         .force = -end.force,
                         .correcting = -end.correcting,
                         .lasting = -end.lasting});
    }
    if (!is_static(world, body_b)) found.push_back(end);
}

void add_distances(const BuiltScene& scene, std::vector<Acting>& found) {
    const engine::World& world = scene.world;
    std::size_t row = 0;
    for (const std::size_t acting : scene.distances->acting()) {
        const engine::Distance& distance = scene.distances->distances()[acting];
        const auto is_of_distance = [](engine::RowKind kind) {
            return kind == engine::RowKind::distance || kind == engine::RowKind::spring;
        };
        while (!is_of_distance(world.rows()[row].label.kind)) ++row;
        const bool ball = is_ball_joint(distance);
        add_ends(world, Acting::Kind::distance, distance.body_a, distance.body_b, span_of(distance, world.bodies),
                 row, ball, found);
        row += ball ? 3 : 1;
    }
}

// Of a joint the part at its point.
void add_joints(const BuiltScene& scene, std::vector<Acting>& found) {
    const engine::World& world = scene.world;
    std::size_t row = 0;
    for (const std::size_t acting : scene.joints->acting()) {
        const engine::Joint& joint = scene.joints->joints()[acting];
        const auto is_of_joint = [&](const engine::RowLabel& label) {
            return label.kind == engine::RowKind::joint && label.point == static_cast<int>(acting);
        };
        while (!is_of_joint(world.rows()[row].label)) ++row;
        add_ends(world, Acting::Kind::joint, joint.body_a, joint.body_b, span_of(joint, world.bodies), row, true,
                 found);
        row += 3;
    }
}

}  // namespace

std::vector<Acting> applied_in(const BuiltScene& scene) {
    std::vector<Acting> found;
    for (const engine::PokeForce* const source : scene.pokes) {
        const int index = source->poke().body;
        const engine::Body& body = scene.world.bodies[static_cast<std::size_t>(index)];
        const Vector3 force = source->force(body.orientation);
        if (!source->acts_at(scene.world.time()) || force.isZero(0.0)) continue;
        found.push_back({.kind = Acting::Kind::outside,
                         .body = index,
                         .other = index,
                         .place = body.position + body.orientation * source->poke().point,
                         .force = force});
    }
    return found;
}

std::vector<Acting> acting_in(const BuiltScene& scene) {
    std::vector<Acting> found;
    if (scene.world.rows().empty()) return found;
    if (scene.contacts) add_contacts(scene, found);
    if (scene.distances) add_distances(scene, found);
    if (scene.joints) add_joints(scene, found);
    return found;
}

}  // namespace pushfactor::demos::pictures
