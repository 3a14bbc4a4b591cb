#include "demos/parts.h"

#include "engine/gravity.h"

namespace pushfactor::demos {

namespace {

std::unique_ptr<engine::FrictionRule> make_friction(FrictionModel model, const engine::Vector3& gravity) {
    switch (model) {
        case FrictionModel::coulomb:
            return std::make_unique<engine::CoulombFriction>();
        case FrictionModel::paper:
            break;
    }
    return std::make_unique<engine::WeightFriction>(gravity);
}

engine::OrientationStep orientation_step(Rotation rotation) {
    switch (rotation) {
        case Rotation::paper:
            return engine::rotate_euler;
        case Rotation::exponential:
            return engine::rotate_exponential;
        case Rotation::splitting:
            break;
    }
    return engine::rotate_splitting;
}

}  // namespace

void add_gravity(Scene& scene) {
    scene.world.forces.push_back(std::make_unique<engine::Gravity>(scene.gravity));
}

void add_contacts(Scene& scene, std::vector<engine::collision::Collider> colliders, double friction,
                  const Settings& settings) {
    const double mu = settings.friction.value_or(friction);
    for (engine::collision::Collider& collider : colliders) collider.friction = mu;

    const engine::ContactChoices choices{
        .correction = settings.contacts,
        .slop = settings.slop,
        .detection = {.margin = settings.margin, .reduce_to_four_points = settings.four_points},
        .order = settings.row_order,
    };
    auto contacts = std::make_unique<engine::ContactStage>(std::move(colliders), choices);
    if (mu > 0.0) contacts->set_friction(make_friction(settings.friction_model, scene.gravity));
    if (settings.warm_start) contacts->set_cache(std::make_unique<engine::ContactCache>());
    scene.contacts = contacts.get();
    scene.world.constraints.push_back(std::move(contacts));
}

void add_solver(Scene& scene, const Settings& settings) {
    scene.world.solver = engine::solvers::make_solver(settings.solver);
    scene.world.termination = {settings.iterations, settings.tolerance_high, settings.tolerance_low};
    scene.world.rotate = orientation_step(settings.rotation);
}

}  // namespace pushfactor::demos
