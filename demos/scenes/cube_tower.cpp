#include "demos/scenes/cube_tower.h"

#include "demos/parts.h"

#include <numbers>
#include <random>

namespace pushfactor::demos::scenes {

namespace {

using engine::Quaternion;
using engine::Vector3;

// Uniform in [0, 1), the same on every platform (the standard distributions are not).
double uniform(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

struct Displacement {
    Vector3 sideways;   // m
    double turn = 0.0;  // rad about the vertical
};

// One draw a statement: the order inside an argument list is the compiler's.
Displacement draw(std::mt19937_64& random, double reach) {
    const double distance = reach * std::sqrt(uniform(random));
    const double direction = 2.0 * std::numbers::pi * uniform(random);
    const double turn = 0.02 * (2.0 * uniform(random) - 1.0);
    return {{distance * std::cos(direction), 0.0, distance * std::sin(direction)}, turn};
}

}  // namespace

Scene cube_tower(const Tower& tower, const Settings& settings) {
    Scene scene;
    scene.standing = Standing{.side = cube_side, .rest_heights = {}};
    std::vector<engine::collision::Collider> colliders;

    scene.world.bodies.push_back(engine::static_body(Vector3::Zero()));
    colliders.push_back({.body = 0, .shape = engine::collision::Plane{}});
    scene.drawn.push_back({.body = 0, .form = Drawn::Form::ground});

    std::mt19937_64 random(static_cast<std::uint64_t>(tower.seed));
    const Vector3 half_size = Vector3::Constant(0.5 * cube_side);
    for (int i = 0; i < tower.count; ++i) {
        const double height = 0.5 * cube_side + tower.ground_gap + i * (cube_side + tower.gap);
        Displacement displacement{Vector3::Zero()};
        if (tower.jitter > 0.0) displacement = draw(random, tower.jitter);
        const int body = i + 1;
        scene.world.bodies.push_back(
            engine::box_body(cube_mass, Vector3::Constant(cube_side), displacement.sideways + Vector3(0, height, 0),
                             Quaternion(Eigen::AngleAxisd(displacement.turn, Vector3::UnitY()))));
        colliders.push_back({.body = body, .shape = engine::collision::Box{half_size}});
        scene.drawn.push_back({.body = body, .form = Drawn::Form::box, .half_size = half_size, .colour = i});
        scene.standing->rest_heights.push_back((i + 0.5) * cube_side);
    }

    add_gravity(scene);
    add_contacts(scene, std::move(colliders), cube_friction, settings);
    add_solver(scene, settings);
    return scene;
}

View view_of_height(double height) {
    // 38 degrees of view show 0.69 m of height per metre of distance; a tenth more on each side is left free.
    const double distance = 1.75 * (height + 2.0);
    const Vector3 target(0, 0.46 * height, 0);
    const Vector3 direction = Vector3(0.45, 0.28, 1.0).normalized();
    return {.eye = target + distance * direction, .target = target};
}

}  // namespace pushfactor::demos::scenes
