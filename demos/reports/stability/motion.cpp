// Cases with fast, spinning or bouncing bodies.
#include "demos/reports/stability/cases.h"
#include "demos/reports/stability/scenes.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports::stability {

namespace {

Chapter impacts() {
    Chapter chapter{"impacts", "Fast bodies that hit: nothing goes through, nothing is thrown back"};
    const OptionTexts options{{"seconds", "2"}};
    for (const double gap : {3.0, 4.1, 5.2}) {
        const BodyDescription cube = box("cube", Vector3::Ones(), {0, 0.5 + gap, 0}, {0, -200, 0});
        chapter.add(fmt::format("cube-200-m-per-s-from-{}", gap), touching("falling-cube", {ground(), cube}),
                    options, "rest", {{"max_penetration_m", 1e-3}, {"max_upward_speed_m_per_s", 0.01}},
                    with_paper("rest", gap == 3.0 ? "creep" : "fly"), gap == 4.1);
    }
    for (const double speed : {10.0, 50.0, 200.0, 1000.0, 1e4}) {
        // Lying on the plate the ball's centre is at height 0. Under paper it goes through, except where a step
        // happens to end inside.
        const bool stops = speed == 10.0;
        chapter.add(fmt::format("ball-on-plate-{}-m-per-s", speed),
                    touching("ball-on-plate",
                             {wall("plate", {4, 0.1, 4}, {0, -0.15, 0}), ball(0.1, {0, 0.32, 0}, {0, -speed, 0})}),
                    options, "rest", {{"depth_m", 1e-3}},
                    with_paper("rest", stops ? "rest" : "tunnel", stops ? Reached{0.022} : Reached{}),
                    speed == 1000.0);
    }
    return chapter;
}

Chapter passing() {
    Chapter chapter{"passing", "A ball that passes an edge at a distance of its radius: is not deflected"};
    for (const double speed : {60.0, 200.0}) {
        for (const bool plate : {true, false}) {
            const Vector3 size = plate ? Vector3(2, 0.1, 2) : Vector3(1, 1, 1);
            SceneDescription scene = touching(
                "ball-past",
                {wall("box", size, Vector3::Zero()), ball(0.1, {0.5 * size.x() + 0.2, 2.13, 0}, {0, -speed, 0})});
            scene.gravity.setZero();
            chapter.add(fmt::format("past-{}-{}-m-per-s", plate ? "plate" : "cube", speed), scene,
                        {{"seconds", "0.3"}}, "moving", {{"deflection_m_per_s", 1e-9}},
                        with_paper("moving", "moving"), speed == 200.0);
        }
    }
    return chapter;
}

// Bodies that spin in place.
Chapter turning() {
    Chapter chapter{"turning",
                    "Free bodies that turn fast or about their middle axis, 60 s: energy and spins stay"};
    const auto add = [&chapter](const std::string& name, const std::string& scene_name, const std::string& body,
                                const Vector3& size, const Vector3& spin, const Checks& checks,
                                const Reached& of_paper, bool quick = false) {
        SceneDescription scene = scene_of(scene_name, {box(body, size, Vector3::Zero())});
        scene.gravity.setZero();
        scene.bodies.front().angular_velocity = spin;
        chapter.add(name, scene, {{"seconds", "60"}}, "moving", checks, with_paper("moving", "moving", of_paper),
                    quick);
    };
    const Check energy{"relative_energy_change", 0.01}, spins{"relative_spin_change", 0.01};
    const Check momentum{"relative_angular_momentum_change", 1e-12};
    const Vector3 rod(2, 0.1, 0.1);  // m; they turn about their length and across
    add("free-rod", "free-rod", "rod", rod, {70.7, 70.7, 0}, {energy, spins, momentum}, {200.0, 200.0}, true);
    // More than half a turn per step.
    add("free-rod-200-rad-per-s", "free-rod", "rod", rod, {200, 200, 0}, {energy, spins, momentum}, {200.0, 200.0});
    // Most of it about its middle axis: its spins are not constant.
    add("free-box", "free-box", "box", {1, 4, 9}, {0.1, 3, 0.1}, {energy, momentum}, {4.0});
    return chapter;
}

SceneDescription tumbling_box() {
    SceneDescription scene =
        with_friction(touching("tumbling-box", {ground(), box("box", {1, 0.4, 0.2}, {0, 2, 0})}), 0.0);
    scene.bodies.back().restitution = 1.0;
    scene.bodies.back().angular_velocity = {1, 4, 3};
    return scene;
}

Chapter bounces() {
    Chapter chapter{"bounces", "Restitution 1: energy stays, bounces are equally high"};
    chapter.add("tumbling-box", tumbling_box(), {{"seconds", "20"}}, "moving", {{"relative_energy_change", 1e-3}},
                with_paper("moving", "fly"));
    chapter.add("bouncing-ball", bouncing_ball(), {{"seconds", "8"}}, "moving", {{"spread_of_5_apexes_m", 1e-9}},
                with_paper("moving", "fly"), true);
    return chapter;
}

}  // namespace

SceneDescription bouncing_ball() {
    SceneDescription scene = touching("bouncing-ball", {ground(), ball(0.1, {0, 2.1, 0})});
    scene.bodies.back().restitution = 1.0;
    return scene;
}

std::vector<Chapter> motion_chapters() {
    return {impacts(), passing(), turning(), bounces()};
}

}  // namespace pushfactor::demos::reports::stability
