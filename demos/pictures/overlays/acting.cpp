#include "demos/pictures/overlays/acting.h"

#include "engine/base/index.h"

#include <map>

namespace pushfactor::demos::pictures {

namespace {

using engine::Vector3;

bool is_static(const engine::World& world, int body) {
    return world.bodies[engine::at(body)].is_static();
}

// Body of a contact that its force is drawn on: 1 for b, -1 for a.
double drawn_on(const engine::ContactSite& site, const engine::World& world) {
    if (is_static(world, site.body_a)) return 1.0;
    if (is_static(world, site.body_b)) return -1.0;
    return site.normal.y() >= 0.0 ? 1.0 : -1.0;
}

void add_contacts(const BuiltScene& scene, std::vector<Acting>& found) {
    const auto add = [&](const engine::ContactSite& site, bool touches, const Vector3& force,
                         const engine::PushFactor& push) {
        const double side = drawn_on(site, scene.world);
        const Vector3 outwards = side * site.normal;
        found.push_back({.kind = touches ? Acting::Kind::touching : Acting::Kind::within_margin,
                         .body = side > 0.0 ? site.body_b : site.body_a,
                         .other = side > 0.0 ? site.body_a : site.body_b,
                         .place = site.position,
                         .force = side * force,
                         .correcting = push.correcting * outwards,
                         .lasting = push.lasting * outwards});
    };
    for (const engine::ContactSite& site : scene.contacts->sites()) {
        const engine::ConstraintRow& row = scene.world.rows()[site.normal_row];
        const double normal_force = lasting_force(scene.world, site.normal_row);
        Vector3 force = site.normal * normal_force;
        for (std::size_t t = 0; site.friction_row && t < 2; ++t) {
            force += site.tangents[t] * lasting_force(scene.world, *site.friction_row + t);
        }
        add(site, row.label.gap <= 0.0 || normal_force > 0.0, force, row.push);
    }
    for (const engine::RestingContact& contact : scene.contacts->sites_at_rest(scene.world.bodies)) {
        add(contact.site, contact.normal > 0.0, contact.force, {});
    }
}

// What acts at the second of two ends: vectors of three numbers along the world's axes, or of one along the span.
struct AtEnd {
    Vector3 force = Vector3::Zero(), correcting = Vector3::Zero(), lasting = Vector3::Zero();

    AtEnd(const engine::World& world, std::size_t first_row, int rows) {
        for (int k = 0; k < rows; ++k) {
            const std::size_t row = first_row + engine::at(k);
            force[k] = lasting_force(world, row);
            correcting[k] = world.rows()[row].push.correcting;
            lasting[k] = world.rows()[row].push.lasting;
        }
    }
    // At rest nothing is pushed.
    AtEnd(std::span<const engine::Lambda> kept, int rows) {
        for (int k = 0; k < rows; ++k) force[k] = kept[engine::at(k)].last;
    }
};

// Rows of what holds points together, and whether one of them is the first of item `i`.
int rows_of(const engine::Distance& distance) {
    return is_ball_joint(distance) ? 3 : 1;
}
bool begins(const engine::RowLabel& label, const engine::Distance&, std::size_t) {
    return label.kind == engine::RowKind::distance || label.kind == engine::RowKind::spring;
}
int rows_of(const engine::Joint&) {
    return 3;  // of the part at its point
}
bool begins(const engine::RowLabel& label, const engine::Joint&, std::size_t i) {
    return label.kind == engine::RowKind::joint && label.point == static_cast<int>(i);
}

// Adds the movable ends of all `items` of a source.
template <typename Source, typename Items>
void add_held(const engine::World& world, Acting::Kind kind, const Source& source, const Items& items,
              std::vector<Acting>& found) {
    std::span<const std::size_t> acting = source.acting();  // ascending
    std::size_t row = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto& item = items[i];
        const bool acts = !acting.empty() && acting.front() == i;
        if (acts) acting = acting.subspan(1);
        while (acts && !begins(world.rows()[row].label, item, i)) ++row;
        const int rows = rows_of(item);
        const AtEnd at_b = acts ? AtEnd(world, row, rows) : AtEnd(source.forces()[i], rows);
        if (acts) row += engine::at(rows);
        const engine::Span span = span_of(item, world.bodies);
        const auto add = [&](int body, int other, const Vector3& place, double sign) {
            const auto vector_of = [&](const Vector3& numbers) {
                const Vector3 vector =
                    rows == 3 ? numbers : Vector3(numbers.x() * (span.to - span.from).normalized());
                return Vector3(sign * vector);
            };
            if (is_static(world, body)) return;
            found.push_back({kind, body, other, place, vector_of(at_b.force), vector_of(at_b.correcting),
                             vector_of(at_b.lasting)});
        };
        add(item.body_a, item.body_b, span.from, -1.0);
        add(item.body_b, item.body_a, span.to, 1.0);
    }
}

}  // namespace

double lasting_force(const engine::World& world, std::size_t row) {
    return world.lambda()(static_cast<Eigen::Index>(row), world.lambda().cols() - 1);
}

std::vector<Acting> applied_in(const BuiltScene& scene) {
    std::vector<Acting> found;
    for (const engine::PokeForce* const source : scene.pokes) {
        const int index = source->poke().body;
        const engine::Body& body = scene.world.bodies[engine::at(index)];
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
    const auto add = [&](Acting::Kind kind, const auto& source, const auto& items) {
        add_held(scene.world, kind, source, items, found);
    };
    if (scene.distances) add(Acting::Kind::distance, *scene.distances, scene.distances->distances());
    if (scene.joints) add(Acting::Kind::joint, *scene.joints, scene.joints->joints());
    return found;
}

std::vector<Acting> all_acting_in(const BuiltScene& scene) {
    std::vector<Acting> acting = acting_in(scene);
    const std::vector<Acting> applied = applied_in(scene);
    acting.insert(acting.end(), applied.begin(), applied.end());
    return acting;
}

std::vector<PressureCentre> pressure_centres(const BuiltScene& scene) {
    struct Pressure {
        Vector3 moment = Vector3::Zero();  // N m, sum of force times place
        double force = 0.0;                // N
    };
    std::map<std::pair<int, int>, Pressure> pairs;
    const auto add = [&](const engine::ContactSite& site, double force) {
        Pressure& pressure = pairs[{site.body_a, site.body_b}];
        pressure.moment += force * site.position;
        pressure.force += force;
    };
    for (const engine::ContactSite& site : scene.contacts->sites())
        add(site, lasting_force(scene.world, site.normal_row));
    for (const engine::RestingContact& contact : scene.contacts->sites_at_rest(scene.world.bodies))
        add(contact.site, contact.normal);
    std::vector<PressureCentre> centres;
    for (const auto& [bodies, pressure] : pairs) {
        if (!(pressure.force > 0.0)) continue;
        centres.push_back({bodies.first, bodies.second, pressure.moment / pressure.force});
    }
    return centres;
}

std::vector<std::pair<Vector3, Vector3>> line_of_thrust(const std::vector<PressureCentre>& centres,
                                                        const BuiltScene& scene) {
    std::map<int, std::vector<Vector3>> of_body;
    for (const PressureCentre& centre : centres) {
        for (const int body : {centre.body_a, centre.body_b}) {
            if (!is_static(scene.world, body)) of_body[body].push_back(centre.place);
        }
    }
    std::vector<std::pair<Vector3, Vector3>> line;
    for (const auto& [body, places] : of_body) {
        if (places.size() == 2) line.emplace_back(places.front(), places.back());
    }
    return line;
}

}  // namespace pushfactor::demos::pictures
