// Cards, planks and rods, ten to a hundred times as long as thick: their contacts are as good as those of cubes.
#include "engine/collision/pairs/pairs.h"
#include "tests/catch.h"
#include "tests/engine/collision/kept.h"
#include "tests/engine/collision/pose.h"
#include "tests/engine/contact_scene.h"
#include "tests/random.h"

#include <algorithm>
#include <cmath>

using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;
using pushfactor::tests::at;
using pushfactor::tests::ContactScene;
using pushfactor::tests::keep_four;
using pushfactor::tests::Random;

namespace {

// A card, a plank or a rod with the edges x >= z >= y, from 10 to 100 times as long as thick.
Vector3 thin_size(Random& random) {
    const double length = random.in(0.5, 2.0);
    const double thickness = length / std::exp(random.in(std::log(10.0), std::log(100.0)));
    return {length, thickness, std::max(thickness, length * random.in(0.02, 1.0))};
}

Quaternion turn(double angle, const Vector3& axis) {
    return Quaternion(Eigen::AngleAxisd(angle, axis.normalized()));
}

// The least translational separation by its definition: over all 15 axes, by projecting all corners.
double brute_force_separation(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
    std::vector<Vector3> axes;
    for (int i = 0; i < 3; ++i) {
        axes.emplace_back(pose_a.rotation.col(i));
        axes.emplace_back(pose_b.rotation.col(i));
        for (int j = 0; j < 3; ++j) {
            const Vector3 cross = pose_a.rotation.col(i).cross(pose_b.rotation.col(j));
            if (cross.norm() > 1e-9) axes.emplace_back(cross.normalized());
        }
    }
    const auto reach = [](const Box& box, const Pose& pose, const Vector3& axis) {
        return (pose.rotation.transpose() * axis).cwiseAbs().dot(box.half_size);
    };
    double largest = -std::numeric_limits<double>::infinity();
    for (const Vector3& axis : axes) {
        const double apart = std::abs(axis.dot(pose_b.position - pose_a.position));
        largest = std::max(largest, apart - reach(a, pose_a, axis) - reach(b, pose_b, axis));
    }
    return largest;
}

double area(const Manifold& manifold) {
    // The points are in the order of the polygon.
    Vector3 twice = Vector3::Zero();
    const auto points = manifold.points();
    for (std::size_t i = 0; i < points.size(); ++i) {
        twice += (points[i].position - points[0].position)
                     .cross(points[(i + 1) % points.size()].position - points[0].position);
    }
    return 0.5 * std::abs(twice.dot(manifold.normal));
}

double deepest(const Manifold& manifold) {
    double depth = -std::numeric_limits<double>::infinity();
    for (const ContactPoint& point : manifold.points()) depth = std::max(depth, -point.gap);
    return depth;
}

// How far `x` is from the convex hull of the points, seen along the normal, at most over all directions [m].
double beside(const Manifold& manifold, const Vector3& x) {
    const Vector3 u = manifold.normal.unitOrthogonal(), v = manifold.normal.cross(u);
    double most = 0.0;
    for (int k = 0; k < 180; ++k) {
        const Vector3 way = std::cos(k * 0.0349066) * u + std::sin(k * 0.0349066) * v;
        double reach = -std::numeric_limits<double>::infinity();
        for (const ContactPoint& point : manifold.points()) reach = std::max(reach, way.dot(point.position));
        most = std::max(most, way.dot(x) - reach);
    }
    return most;
}

}  // namespace

TEST_CASE("the depth of two thin boxes is the least distance that parts them, nearly parallel or not") {
    Random random(41);
    int touching = 0;
    double worst = 0.0;
    for (int i = 0; i < 40000; ++i) {
        const Vector3 size_a = thin_size(random), size_b = thin_size(random);
        const Box a{0.5 * size_a}, b{0.5 * size_b};
        const double thickness = std::min(size_a.y(), size_b.y());
        const Quaternion of_a = random.rotation();
        // Half of them nearly parallel, by angles of 1e-7 to 0.1.
        const Quaternion tilt = turn(std::exp(random.in(std::log(1e-7), std::log(0.1))), random.vector(-1, 1));
        const bool is_parallel = i % 2 == 0;
        const Quaternion of_b = is_parallel ? of_a * tilt : random.rotation();
        const Pose pose_a = at(Vector3::Zero(), of_a);
        Vector3 offset = random.vector(-1, 1).cwiseProduct(0.5 * (size_a + size_b));
        if (is_parallel) offset[static_cast<int>(random.in(0, 3))] *= random.in(0.9, 1.0) / 0.95;
        const Pose pose_b = at(of_a * offset, of_b);
        const double separation = brute_force_separation(a, pose_a, b, pose_b);
        if (std::abs(separation) < 1e-6) continue;
        Manifold manifold;
        collide_box_box(a, pose_a, b, pose_b, 0.0, manifold);
        INFO("case " << i << " separation " << separation << " thickness " << thickness);
        REQUIRE((manifold.count > 0) == (separation < 0.0));
        if (manifold.count == 0) continue;
        ++touching;
        worst = std::max(worst, std::abs(deepest(manifold) + separation) / thickness);
        REQUIRE(std::abs(deepest(manifold) + separation) < 2e-3 * thickness);
    }
    CHECK(touching > 5000);
    CAPTURE(worst);
    CHECK(worst < 2e-3);
}

TEST_CASE("a thin box on another touches in all corners and edge crossings of their common face") {
    Random random(42);
    for (int i = 0; i < 4000; ++i) {
        const Vector3 size_a = thin_size(random), size_b = thin_size(random);
        const Box a{0.5 * size_a}, b{0.5 * size_b};
        const double yaw = i % 2 ? random.in(-3.2, 3.2) : random.in(-1e-3, 1e-3);
        const double thickness = std::min(size_a.y(), size_b.y());
        const Pose pose_a = at(Vector3::Zero());
        Vector3 offset = 0.4 * random.vector(-1, 1).cwiseProduct(size_a);
        offset.y() = 0.5 * (size_a.y() + size_b.y()) - 1e-3 * thickness;
        const Pose pose_b = at(offset, turn(yaw, Vector3::UnitY()));
        Manifold manifold;
        collide_box_box(a, pose_a, b, pose_b, 0.01 * thickness, manifold);
        REQUIRE(std::abs(manifold.normal.y()) > 0.999);
        // Reference on a grid: what lies in both faces lies in the hull of the points.
        for (int k = 0; k < 50; ++k) {
            const Vector3 in_b = 0.5 * random.vector(-1, 1).cwiseProduct(size_b);
            const Vector3 x = pose_b.position + pose_b.rotation * in_b;
            if (std::abs(x.x()) > a.half_size.x() || std::abs(x.z()) > a.half_size.z()) continue;
            REQUIRE(beside(manifold, x) < 1e-9);
        }
    }
}

TEST_CASE("four points of a long overlap span most of it, whatever the direction") {
    Random random(43);
    int reduced_ones = 0;
    double least = 1.0;
    for (int i = 0; i < 20000; ++i) {
        const Vector3 size_b = thin_size(random);
        const Box floor{{3.0, 0.5, 3.0}}, b{0.5 * size_b};
        // A plank that juts out over the edge or the corner of a plate.
        const double yaw = random.in(-3.2, 3.2);
        const double z = random.in(0, 1) < 0.5 ? 0.0 : 3.0 - random.in(-0.2, 0.5) * size_b.x();
        const double x = 3.0 - random.in(-0.2, 0.5) * size_b.x();
        const Vector3 offset(x, 0.5 + 0.5 * size_b.y() - 1e-9, z);
        Manifold full;
        collide_box_box(floor, at(Vector3::Zero()), b, at(offset, turn(yaw, Vector3::UnitY())), 1e-4, full);
        if (full.count <= 4) continue;
        ++reduced_ones;
        Manifold reduced = full;
        keep_four(reduced);
        const double share = area(reduced) / area(full);
        least = std::min(least, share);
        INFO("case " << i << " size " << size_b.transpose() << " yaw " << yaw);
        CHECK(share > 0.5);
    }
    CHECK(reduced_ones > 500);
    CAPTURE(least);
    CHECK(least > 0.5);
}

namespace {

// The displacement, rotation and final speed of bodies that should stay.
struct Drift {
    double place = 0.0, turn = 0.0, speed = 0.0, gain = 0.0;
};

Drift drift_of(ContactScene& scene, int steps) {
    for (int n = 0; n < 30; ++n) scene.world.step(ContactScene::dt);
    const std::vector<Body> before = scene.world.bodies;
    const Vector3 gravity(0, -10, 0);
    const double energy = kinetic_energy(before) + potential_energy(before, gravity);
    Drift drift;
    for (int n = 0; n < steps; ++n) {
        scene.world.step(ContactScene::dt);
        const auto& bodies = scene.world.bodies;
        drift.gain = std::max(drift.gain, kinetic_energy(bodies) + potential_energy(bodies, gravity) - energy);
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Body& body = scene.world.bodies[i];
        drift.place = std::max(drift.place, (body.position - before[i].position).norm());
        drift.turn = std::max(drift.turn, body.orientation.angularDistance(before[i].orientation));
    }
    drift.speed = max_speed(scene.world.bodies);
    return drift;
}

}  // namespace

TEST_CASE("planks across two others, cards and rods on a floor stay where they are, like cubes") {
    Random random(44);
    int moved = 0;
    for (int i = 0; i < 40; ++i) {
        ContactScene scene;
        scene.add_plate({20, 1, 20}, {0, -0.5, 0}, {.friction = 0.8});
        const double ratio = i % 4 == 0 ? 1.0 : std::exp(random.in(std::log(10.0), std::log(100.0)));
        const double thickness = i % 4 == 0 ? 0.3 : 1.0 / ratio;
        const Vector3 size(i % 4 == 0 ? 0.3 : 1.0, thickness,
                           i % 4 == 0 ? 0.3 : std::max(thickness, random.in(0.03, 0.6)));
        const double turned = random.in(-3.2, 3.2);
        const auto put = [&](const Vector3& place, double yaw) {
            scene.add_box(size, turn(turned, Vector3::UnitY()) * place, {0, 0, 0}, {.friction = 0.8}).orientation =
                turn(turned + yaw, Vector3::UnitY());
        };
        const double apart = i % 4 == 0 ? 0.375 : 0.7;
        put({-0.5 * apart, 0.5 * thickness, 0}, 1.5708 + random.in(-0.2, 0.2));
        put({0.5 * apart, 0.5 * thickness, 0}, 1.5708 + random.in(-0.2, 0.2));
        put({0, 1.5 * thickness, 0}, random.in(-0.2, 0.2));
        put({0, 2.5 * thickness, 0}, random.in(-0.01, 0.01));
        scene.build();
        const Drift drift = drift_of(scene, 180);
        INFO("case " << i << " size " << size.transpose() << " drift " << drift.place << " m, " << drift.turn
                     << " rad, " << drift.speed << " m/s, gains " << drift.gain << " J");
        const bool stays = drift.place < 5e-5 && drift.turn < 1e-4 && drift.speed < 1e-6 && drift.gain < 1e-6;
        if (!stays) WARN("case " << i << " moves by " << drift.place << " m");
        moved += stays ? 0 : 1;
    }
    // One of them, 66 times as long as thick, jams while it settles: neither changes of the active set nor 25
    // sweeps solve its cones.
    CHECK(moved <= 1);
}
