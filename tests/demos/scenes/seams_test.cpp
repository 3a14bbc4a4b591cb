// Floors and walls of flush boxes: bodies that slide or roll over a seam move as on a single box.
#include "engine/bodies/diagnostics.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Body;
using engine::Quaternion;
using engine::Vector3;
using tests::Random;

namespace {

// The setting of a scene: a slider on a floor whose top is at y = 0, that comes from about the origin and moves
// along +x.
struct Trip {
    std::variant<BoxShape, SphereShape> shape = BoxShape{};
    double speed = 4.0;                        // m/s
    double turn = 0.0;                         // rad about the vertical
    Vector3 tile{1.0, 1.0, 1.0};               // m
    double depth = 0.0;                        // m, at which the slider lies in the floor
    double offset = 0.0;                       // m, of a seam from the origin
    double uneven = 0.0;                       // m, how much higher every other tile is
    double frames = 60;                        // of 1/60 s
    bool is_movable = false;                   // the tiles, which then lie on a plate
    Quaternion tilt = Quaternion::Identity();  // of the whole scene, its gravity too
};

double half_height(const Trip& trip) {
    if (const auto* box = std::get_if<BoxShape>(&trip.shape)) return 0.5 * box->size.y();
    return std::get<SphereShape>(trip.shape).radius;
}

double radius_of(const Trip& trip) {
    if (const auto* box = std::get_if<BoxShape>(&trip.shape)) return 0.5 * box->size.norm();
    return std::get<SphereShape>(trip.shape).radius;
}

void add_tiles(const Trip& trip, SceneDescription& scene) {
    const double end = trip.speed * trip.frames / 60.0 + 2.0 * radius_of(trip) + 1.0;
    const double side = radius_of(trip) + trip.tile.z();
    const int first = -static_cast<int>(std::ceil((2.0 * radius_of(trip) + 1.0) / trip.tile.x()));
    int count = 0;
    for (int i = first; trip.offset + i * trip.tile.x() < end; ++i) {
        for (int k = -static_cast<int>(std::ceil(side / trip.tile.z())); k * trip.tile.z() < side; ++k) {
            BodyDescription tile{.name = "tile " + std::to_string(count++), .shape = BoxShape{trip.tile}};
            const double height = (i + k) % 2 ? trip.uneven : 0.0;
            tile.position = {trip.offset + (i + 0.5) * trip.tile.x(), height - 0.5 * trip.tile.y(),
                             0.3 * trip.offset + (k + 0.5) * trip.tile.z()};
            if (trip.is_movable) tile.mass = 1000.0;
            tile.friction = 0.0;
            scene.bodies.push_back(tile);
        }
    }
    if (!trip.is_movable) return;
    BodyDescription bed{.name = "bed", .shape = BoxShape{{4.0 * end + 100.0, 1.0, 100.0}}};
    bed.position = {0, -trip.tile.y() - 0.5, 0};
    scene.bodies.push_back(bed);
}

void add_single_floor(const Trip& trip, SceneDescription& scene) {
    const double length = 2.0 * (trip.speed * trip.frames / 60.0 + 10.0 * radius_of(trip) + 10.0);
    BodyDescription floor{.name = "floor", .shape = BoxShape{{length, trip.tile.y(), length}}};
    floor.position = {0, -0.5 * trip.tile.y(), 0};
    floor.friction = 0.0;
    if (trip.is_movable) floor.mass = 1e5;
    scene.bodies.push_back(floor);
    if (!trip.is_movable) return;
    BodyDescription bed{.name = "bed", .shape = BoxShape{{length + 10.0, 1.0, length + 10.0}}};
    bed.position = {0, -trip.tile.y() - 0.5, 0};
    scene.bodies.push_back(bed);
}

SceneDescription scene_of(const Trip& trip, bool tiles) {
    SceneDescription scene;
    scene.contacts = true;
    (tiles ? add_tiles : add_single_floor)(trip, scene);
    BodyDescription slider{.name = "slider", .mass = 1.0};
    std::visit([&](const auto& shape) { slider.shape = shape; }, trip.shape);
    slider.position = {0, half_height(trip) - trip.depth, 0};
    slider.orientation = Quaternion(Eigen::AngleAxisd(trip.turn, Vector3::UnitY()));
    slider.velocity = {trip.speed, 0, 0};
    slider.friction = 0.0;
    if (std::holds_alternative<SphereShape>(trip.shape))
        slider.angular_velocity = {0, 0, -trip.speed / half_height(trip)};
    scene.bodies.push_back(slider);
    for (BodyDescription& body : scene.bodies) {
        body.position = trip.tilt * body.position;
        body.orientation = trip.tilt * body.orientation;
        body.velocity = trip.tilt * body.velocity;
        body.angular_velocity = trip.tilt * body.angular_velocity;
    }
    scene.gravity = trip.tilt * scene.gravity;
    return scene;
}

Settings with(const char* preset, int substeps) {
    Settings settings = tests::awake_settings(preset);
    settings.substeps = substeps;
    return settings;
}

// The largest deviation of the slider from its motion on a single box [m; m/s for velocities; 1 for the turn].
struct Difference {
    double place = 0.0, velocity = 0.0, turn = 0.0;

    double largest() const { return std::max({place, velocity, turn}); }
};

Difference difference(const Trip& trip, const Settings& settings) {
    Simulation tiled(build_scene(scene_of(trip, true), settings), settings);
    Simulation single(build_scene(scene_of(trip, false), settings), settings);
    Difference most;
    for (int n = 0; n < trip.frames; ++n) {
        tiled.advance();
        single.advance();
        const Body& body = tiled.scene().world.bodies.back();
        const Body& wanted = single.scene().world.bodies.back();
        most.place = std::max(most.place, (body.position - wanted.position).norm());
        most.velocity = std::max(most.velocity, (engine::velocity(body) - engine::velocity(wanted)).norm());
        most.turn = std::max(most.turn, body.orientation.angularDistance(wanted.orientation));
    }
    return most;
}

std::string text(const Trip& trip, const Settings& settings) {
    std::ostringstream out;
    if (const auto* box = std::get_if<BoxShape>(&trip.shape)) {
        out << "box " << box->size.transpose();
    } else {
        out << "ball " << radius_of(trip);
    }
    out << " at " << trip.speed << " m/s turned by " << trip.turn << " on tiles " << trip.tile.transpose()
        << " offset " << trip.offset << " uneven " << trip.uneven << (trip.is_movable ? " movable" : "") << ", "
        << settings.preset << " " << *settings.substeps;
    return out.str();
}

Trip random_trip(Random& random) {
    Trip trip;
    const double size = std::exp(random.in(std::log(0.05), std::log(2.0)));
    switch (static_cast<int>(random.in(0, 3))) {
        case 0:
            trip.shape = BoxShape{Vector3::Constant(size)};
            break;
        case 1:
            trip.shape = SphereShape{0.5 * size};
            break;
        default:
            trip.shape =
                BoxShape{{size * random.in(0.5, 5.0), size * random.in(0.1, 0.5), size * random.in(0.3, 1.0)}};
    }
    trip.speed = std::exp(random.in(std::log(0.1), std::log(50.0)));
    trip.turn = random.in(0, 1) < 0.3 ? 0.0 : random.in(-3.2, 3.2);
    trip.tile = {size * random.in(0.6, 4.0), random.in(0.1, 1.0), size * random.in(0.6, 4.0)};
    trip.offset = random.in(-0.5, 0.5) * trip.tile.x();
    trip.frames = std::clamp(std::ceil(60.0 * 12.0 * trip.tile.x() / trip.speed), 30.0, 120.0);
    return trip;
}

const Body& slider_of(const Simulation& simulation) {
    return simulation.scene().world.bodies.back();
}

// Measured over 300 trips each: 5.2e-8 (default), 9.4e-8 (default, 16 substeps), 1.1e-10 and 1.2e-10 (exact).
void check_like_one_floor(const Trip& trip, const Settings& settings) {
    const Difference seen = difference(trip, settings);
    INFO(text(trip, settings) << ": " << seen.place << " m, " << seen.velocity << " m/s, " << seen.turn);
    CHECK(seen.largest() < 1e-6);
}

// Settled: a body that first has to sink to the depth that its rows aim at tilts by as much meanwhile.
void settle(Trip& trip, const Settings& settings) {
    const auto* box = std::get_if<BoxShape>(&trip.shape);
    trip.depth = 2e-3 * settings.slop * (box ? box->size.minCoeff() : 2.0 * half_height(trip));
}

template <typename Check>
void in_all_settings(Check check) {
    for (const char* preset : {"default", "exact"}) {
        for (const int substeps : {1, 16}) check(with(preset, substeps));
    }
}

}  // namespace

TEST_CASE("cubes, balls and planks pass seams as if there were none, at 0.1 to 50 m/s, turned at random") {
    in_all_settings([](const Settings& settings) {
        Random random(7);
        for (int i = 0; i < 12; ++i) {
            Trip trip = random_trip(random);
            settle(trip, settings);
            check_like_one_floor(trip, settings);
        }
    });
}

TEST_CASE("seams of a slope, a wall or a ceiling are passed like those of a floor") {
    in_all_settings([](const Settings& settings) {
        Random random(8);
        for (int i = 0; i < 6; ++i) {
            Trip trip = random_trip(random);
            settle(trip, settings);
            trip.tilt = random.rotation();
            check_like_one_floor(trip, settings);
        }
    });
}

TEST_CASE("seams of a floor of movable blocks are passed like those of a fixed one") {
    in_all_settings([](const Settings& settings) {
        Random random(9);
        for (int i = 0; i < 3; ++i) {
            Trip trip = random_trip(random);
            trip.is_movable = true;
            trip.frames = 20;
            trip.speed = std::min(trip.speed, 5.0);
            trip.tile = Vector3::Constant(random.in(0.5, 2.0) * 2.0 * radius_of(trip));
            trip.offset = random.in(-0.5, 0.5) * trip.tile.x();
            Simulation simulation(build_scene(scene_of(trip, true), settings), settings);
            for (int n = 0; n < trip.frames; ++n) simulation.advance();
            const Vector3 velocity = engine::velocity(slider_of(simulation));
            INFO(text(trip, settings) << " ends with " << velocity.transpose());
            // In small steps blocks give way to what rolls over them, by less than the slop.
            const double loss = settings.scheme == Scheme::automatic ? 2e-3 : 1e-4;
            CHECK(std::abs(velocity.x() - trip.speed) < loss * trip.speed);
            CHECK(std::abs(velocity.z()) < loss * trip.speed);
        }
    });
}

TEST_CASE("steps lower than the slop cost nothing along the way") {
    for (const int substeps : {1, 16}) {
        const Settings settings = with("default", substeps);
        Random random(10);
        for (int i = 0; i < 8; ++i) {
            Trip trip = random_trip(random);
            if (i % 2 == 0) trip.shape = BoxShape{Vector3::Constant(random.in(0.1, 1.0))};
            const auto* box = std::get_if<BoxShape>(&trip.shape);
            trip.uneven = 0.9 * settings.slop * (box ? box->size.minCoeff() : 2.0 * half_height(trip));
            Simulation simulation(build_scene(scene_of(trip, true), settings), settings);
            for (int n = 0; n < trip.frames; ++n) simulation.advance();
            const Vector3 velocity = engine::velocity(slider_of(simulation));
            INFO(text(trip, settings) << " ends with " << velocity.transpose());
            CHECK(velocity.x() > 0.97 * trip.speed);
            CHECK(velocity.x() < 1.01 * trip.speed);
        }
    }
}

TEST_CASE("walls, and steps higher than the slop, stop a cube at every speed") {
    in_all_settings([](const Settings& settings) {
        for (const double speed : {0.1, 1.0, 4.0, 15.0, 50.0}) {
            for (const double height : {0.003, 0.01, 0.2, 0.99}) {
                Trip trip{.speed = speed};
                SceneDescription scene = scene_of(trip, true);
                const BodyDescription slider = scene.bodies.back();
                scene.bodies.pop_back();
                BodyDescription step{.name = "step", .shape = BoxShape{{2.0, 2.0, 6.0}}};
                step.position = {0.5 + 0.031 + 1.0, height - 1.0, 0};
                step.friction = 0.0;
                scene.bodies.push_back(step);
                scene.bodies.push_back(slider);
                Simulation simulation(build_scene(scene, settings), settings);
                for (int n = 0; n < 30; ++n) simulation.advance();
                INFO(speed << " m/s against a step of " << height << " m, " << settings.preset << " "
                           << settings.substeps.value());
                CHECK(engine::velocity(slider_of(simulation)).x() < 0.9 * speed);
                // A low step trips fast bodies, a high one stops them.
                if (height > 0.5) CHECK(slider_of(simulation).position.x() < 0.031 + 1e-4);
            }
        }
    });
}

TEST_CASE("what falls on a seam lands on it as on one box") {
    in_all_settings([](const Settings& settings) {
        Random random(11);
        for (int i = 0; i < 8; ++i) {
            Trip trip = random_trip(random);
            trip.depth = -random.in(0.0, 0.3);  // above the floor
            trip.frames = 30;
            check_like_one_floor(trip, settings);
        }
    });
}

TEST_CASE("a cube that rests with a side on a seam begins to slide when it is pushed") {
    in_all_settings([](const Settings& settings) {
        for (const double angle : {0.02, 0.3}) {  // rad, of a slope
            Trip trip{.speed = 0.0, .offset = 0.5, .tilt = Quaternion(Eigen::AngleAxisd(-angle, Vector3::UnitZ()))};
            settle(trip, settings);
            SceneDescription scene = scene_of(trip, true);
            scene.gravity = {0, -10, 0};
            Simulation simulation(build_scene(scene, settings), settings);
            for (int n = 0; n < 30; ++n) simulation.advance();
            const Vector3 velocity = trip.tilt.conjugate() * engine::velocity(slider_of(simulation));
            CHECK(velocity.x() == Approx(10.0 * std::sin(angle) * 0.5).epsilon(1e-4));
        }
    });
}
