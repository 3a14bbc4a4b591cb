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
    for (const engine::RestingContact& contact : scene.contacts->sites_at_rest(scene.world.bodies)) {
        const double side = drawn_on(contact.site, scene.world);
        found.push_back({.kind = contact.normal > 0.0 ? Acting::Kind::touching : Acting::Kind::within_margin,
                         .body = side > 0.0 ? contact.site.body_b : contact.site.body_a,
                         .other = side > 0.0 ? contact.site.body_a : contact.site.body_b,
                         .place = contact.site.position,
                         .force = side * contact.force});
    }
}

// What acts at the second of two ends: vectors of three numbers along the world's axes, or of one along the span.
struct AtEnd {
    Vector3 force = Vector3::Zero(), correcting = Vector3::Zero(), lasting = Vector3::Zero();

    AtEnd(const engine::World& world, std::size_t first_row, int rows) {
        for (int k = 0; k < rows; ++k) {
            const auto& [row, lasting_force] = answer_of(world, first_row + static_cast<std::size_t>(k));
            force[k] = lasting_force;
            correcting[k] = row.push.correcting;
            lasting[k] = row.push.lasting;
        }
    }
    // At rest nothing is pushed.
    AtEnd(std::span<const engine::Lambda> kept, int rows) {
        for (int k = 0; k < rows; ++k) force[k] = kept[static_cast<std::size_t>(k)].last;
    }
};

// Adds the movable ends of something between two bodies.
void add_ends(const engine::World& world, Acting::Kind kind, int body_a, int body_b, const engine::Span& span,
              const AtEnd& at_b, bool along_axes, std::vector<Acting>& found) {
    const auto vector_of = [&](const Vector3& numbers) {
        return along_axes ? numbers : Vector3(numbers.x() * (span.to - span.from).normalized());
    };
    const Acting end{.kind = kind,
                     .body = body_b,
                     .other = body_a,
                     .place = span.to,
                     .force = vector_of(at_b.force),
                     .correcting = vector_of(at_b.correcting),
                     .lasting = vector_of(at_b.lasting)};
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

// Calls `visit(i, acts)` for all of `count` items; those that act are `acting`, ascending.
template <typename Visit>
void each_item(std::size_t count, std::span<const std::size_t> acting, const Visit& visit) {
    for (std::size_t i = 0; i < count; ++i) {
        const bool acts = !acting.empty() && acting.front() == i;
        if (acts) acting = acting.subspan(1);
        visit(i, acts);
    }
}

void add_distances(const BuiltScene& scene, std::vector<Acting>& found) {
    const engine::World& world = scene.world;
    const auto is_of_distance = [](engine::RowKind kind) {
        return kind == engine::RowKind::distance || kind == engine::RowKind::spring;
    };
    std::size_t row = 0;
    const auto& distances = scene.distances->distances();
    each_item(distances.size(), scene.distances->acting(), [&](std::size_t i, bool acts) {
        const bool ball = is_ball_joint(distances[i]);
        const int rows = ball ? 3 : 1;
        while (acts && !is_of_distance(world.rows()[row].label.kind)) ++row;
        const AtEnd end = acts ? AtEnd(world, row, rows) : AtEnd(scene.distances->forces()[i], rows);
        add_ends(world, Acting::Kind::distance, distances[i].body_a, distances[i].body_b,
                 span_of(distances[i], world.bodies), end, ball, found);
        if (acts) row += static_cast<std::size_t>(rows);
    });
}

// Of a joint the part at its point.
void add_joints(const BuiltScene& scene, std::vector<Acting>& found) {
    const engine::World& world = scene.world;
    std::size_t row = 0;
    const auto& joints = scene.joints->joints();
    each_item(joints.size(), scene.joints->acting(), [&](std::size_t i, bool acts) {
        const auto is_of_joint = [&](const engine::RowLabel& label) {
            return label.kind == engine::RowKind::joint && label.point == static_cast<int>(i);
        };
        while (acts && !is_of_joint(world.rows()[row].label)) ++row;
        const AtEnd end = acts ? AtEnd(world, row, 3) : AtEnd(scene.joints->forces()[i], 3);
        add_ends(world, Acting::Kind::joint, joints[i].body_a, joints[i].body_b, span_of(joints[i], world.bodies),
                 end, true, found);
        if (acts) row += 3;
    });
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

bool any_forces(const BuiltScene& scene) {
    return !scene.world.rows().empty() || (scene.world.rest && scene.world.rest->count() > 0);
}

std::vector<Acting> acting_in(const BuiltScene& scene) {
    std::vector<Acting> found;
    if (!any_forces(scene)) return found;
    if (scene.contacts) add_contacts(scene, found);
    if (scene.distances) add_distances(scene, found);
    if (scene.joints) add_joints(scene, found);
    return found;
}

}  // namespace pushfactor::demos::pictures
