#include "demos/runs/build/scene_parts.h"
#include "engine/base/invalid_input.h"
#include "engine/base/overloaded.h"
#include "engine/impacts/impacts.h"

#include <algorithm>
#include <map>

namespace pushfactor::demos {

namespace {

using engine::Vector3;
namespace collision = engine::collision;

collision::Shape make_shape(const BodyDescription& described) {
    return std::visit(
        engine::Overloaded{
            [](const BoxShape& box) -> collision::Shape { return collision::Box{0.5 * box.size}; },
            [](const SphereShape& sphere) -> collision::Shape { return collision::Sphere{sphere.radius}; },
            [](const PlaneShape&) -> collision::Shape { return collision::Plane{}; },
            [](const PolyhedronShape& polyhedron) -> collision::Shape {
                return collision::Polyhedron{polyhedron.mesh};
            }},
        described.shape);
}

engine::FrictionRule make_friction(FrictionModel model, const Vector3& gravity) {
    if (model == FrictionModel::cone) return engine::cone_friction;
    if (model == FrictionModel::coulomb) return engine::coulomb_friction;
    return engine::weight_friction(gravity);
}

// The numbers of what the bodies name, by body and by name: groups or materials. Negative without a name.
struct Numbers {
    Numbers(const SceneDescription& description, std::string BodyDescription::*what) {
        for (const BodyDescription& body : description.bodies) {
            const std::string& name = body.*what;
            of_bodies.push_back(name.empty() ? -1 : by_name.emplace(name, by_name.size()).first->second);
        }
    }
    std::vector<int> of_bodies;
    std::map<std::string, int> by_name;
};

// Pairs that do not touch, beside those of groups: named ones, and those of joints.
std::vector<collision::Pair> pairs_without_contacts(const SceneDescription& description) {
    std::vector<collision::Pair> pairs;
    for (const auto& [a, b] : description.no_contacts) {
        pairs.push_back({index_of(a, description), index_of(b, description)});
    }
    for (const JointDescription& joint : description.joints) {
        if (joint.collide || joint.a.body == "world" || joint.b.body == "world") continue;
        pairs.push_back({index_of(joint.a.body, description), index_of(joint.b.body, description)});
    }
    return pairs;
}

std::unique_ptr<collision::PairFilter> make_filter(const SceneDescription& description,
                                                   const std::vector<collision::Pair>& pairs) {
    const Numbers groups(description, &BodyDescription::group);
    if (groups.by_name.empty() && pairs.empty()) return nullptr;
    return std::make_unique<collision::PairFilter>(groups.by_name.empty() ? std::vector<int>() : groups.of_bodies,
                                                   pairs);
}

// The options --friction and --restitution are for all pairs.
std::unique_ptr<collision::MaterialPairs> make_materials(const SceneDescription& description,
                                                         const Settings& settings) {
    if (description.materials.empty()) return nullptr;
    const auto numbers = Numbers(description, &BodyDescription::material).by_name;
    auto materials = std::make_unique<collision::MaterialPairs>(static_cast<int>(numbers.size()));
    const auto number_of = [&](const std::string& name) {
        const auto found = numbers.find(name);
        if (found == numbers.end()) throw engine::InvalidInput("material", name, "the material of a body");
        return found->second;
    };
    for (const MaterialPairDescription& pair : description.materials) {
        collision::MaterialPairs::Surface surface;
        if (!settings.friction) surface.friction = pair.friction;
        if (!settings.restitution) surface.restitution = pair.restitution;
        materials->set(number_of(pair.a), number_of(pair.b), surface);
    }
    return materials;
}

std::vector<collision::Collider> make_colliders(const SceneDescription& description, const Settings& settings) {
    const Numbers materials(description, &BodyDescription::material);
    std::vector<collision::Collider> colliders;
    for (int i = 0; i < static_cast<int>(description.bodies.size()); ++i) {
        const BodyDescription& body = description.bodies[static_cast<std::size_t>(i)];
        if (!body.measured_of.empty()) continue;
        colliders.push_back({.body = i,
                             .shape = make_shape(body),
                             .friction = settings.friction.value_or(body.friction),
                             .restitution = settings.restitution.value_or(body.restitution),
                             .surface_velocity = body.surface_velocity,
                             .surface_from = body.surface_from,
                             .material = materials.of_bodies[static_cast<std::size_t>(i)]});
    }
    return colliders;
}

}  // namespace

void add_contacts(BuiltScene& scene, const SceneDescription& description, const Settings& settings) {
    if (!description.contacts) return;
    const std::vector<collision::Collider> colliders = make_colliders(description, settings);
    const auto any = [&](double collision::Collider::*what) {
        return std::ranges::any_of(colliders, [what](const auto& c) { return c.*what > 0.0; });
    };
    const engine::ContactChoices choices{
        .correction = settings.contacts,
        .slop = settings.slop,
        .detection = {.margin = settings.margin, .reduce_to_four_points = settings.four_points},
        .order = settings.row_order,
    };
    auto contacts = std::make_unique<engine::ContactConstraints>(colliders, choices);
    auto materials = make_materials(description, settings);
    if (any(&collision::Collider::friction) ||
        (materials && materials->any(&collision::MaterialPairs::Surface::friction))) {
        contacts->set_friction(make_friction(settings.friction_model, scene.gravity));
    }
    if (any(&collision::Collider::restitution) ||
        (materials && materials->any(&collision::MaterialPairs::Surface::restitution))) {
        if (settings.restitution_model == RestitutionModel::sum) {
            contacts->set_restitution(engine::restitution_sum);
        } else {
            scene.world.impacts = std::make_unique<engine::Impacts>(*contacts);
        }
    }
    if (settings.margin > 0.0)
        contacts->set_continuous_collision(std::make_unique<collision::ContinuousCollision>());
    if (settings.warm_start) contacts->set_cache(std::make_unique<engine::ContactCache>());
    contacts->set_materials(std::move(materials));
    contacts->set_mechanisms(mechanisms_of(scene));
    scene.no_contacts = pairs_without_contacts(description);
    contacts->set_filter(make_filter(description, scene.no_contacts));
    scene.contacts = contacts.get();
    scene.world.constraints.push_back(std::move(contacts));
}

}  // namespace pushfactor::demos
