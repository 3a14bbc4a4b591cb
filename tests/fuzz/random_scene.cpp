#include "tests/fuzz/random_scene.h"

#include "demos/base/text/numbers.h"
#include "demos/options/simulation_options.h"
#include "engine/base/invalid_input.h"
#include "tests/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace pushfactor::tests {

namespace {

using demos::BodyDescription;
using demos::SceneDescription;
using engine::Vector3;

// The choices for an option; the first one leaves it to the preset.
struct OptionChoices {
    const char* name;
    std::vector<const char*> texts;
};

const std::array option_choices{
    OptionChoices{"solver", {"", "pgs", "dense", "jacobi", "nncg", "direct", "auto"}},
    OptionChoices{"iterations", {"", "", "", "1", "4", "100"}},
    OptionChoices{"tolerance", {"", "", "", "0", "1e-6", "1e-3/1e-6"}},
    OptionChoices{"push", {"", "none", "persistent", "single-frame"}},
    OptionChoices{"beta", {"", "", "0.05", "0.5", "1"}},
    OptionChoices{"distance-push", {"", "none", "persistent", "single-frame"}},
    OptionChoices{"distance-beta", {"", "", "0.05", "0.5", "1"}},
    OptionChoices{"warm-start", {"", "on", "off"}},
    OptionChoices{"slop", {"", "", "0", "0.05"}},
    OptionChoices{"margin", {"", "", "0", "0.1", "1"}},
    OptionChoices{"row-order", {"", "bottom-up", "reverse", "creation", "normals-first"}},
    OptionChoices{"manifold-points", {"", "4", "8"}},
    OptionChoices{"friction-model", {"", "paper", "coulomb", "cone"}},
    OptionChoices{"restitution-model", {"", "sum", "larger"}},
    OptionChoices{"start-kick", {"", "", "on", "off"}},
    OptionChoices{"rotation", {"", "paper", "exponential", "splitting"}},
    OptionChoices{"substeps", {"", "", "", "2", "3"}},
    OptionChoices{"rest", {"", "off", "on"}},
};

class Generator {
  public:
    explicit Generator(std::uint64_t seed) : random_(seed), shapes_(seed + 0x5eed) {
        scene_.name = "fuzz-" + std::to_string(seed);
        size_ = decades(-3, 3);
        mass_ = decades(-4, 4);
        wild_ = chance(0.3);
        spread_ = decades(-0.5, 0.7);
        speed_ = chance(0.3) ? 0.0 : decades(-2, chance(0.2) ? 3 : 1);
    }

    SceneDescription make() {
        scene_.contacts = chance(0.9);
        const bool isolated = chance(0.5);
        if (!isolated) add_surroundings();
        const int count = static_cast<int>(random_.in(1, 9));
        for (int i = 0; i < count; ++i) add_body(i);
        if (chance(0.5)) add_distances(isolated);
        if (!isolated && chance(0.3)) add_force();
        add_options();
        if (chance(0.2)) add_pairs();
        if (chance(0.5)) turn_forces();
        if (chance(0.2)) add_joints(isolated);
        if (chance(0.2)) soften_distances();
        for (BodyDescription& body : scene_.bodies) {
            if (!body.mass && chance(0.3)) body.motion = motion();
        }
        return std::move(scene_);
    }

  private:
    bool chance(double share) { return random_.in(0, 1) < share; }
    std::size_t below(std::size_t count) {
        return static_cast<std::size_t>(random_.in(0, static_cast<double>(count)));
    }
    double in(double low, double high) { return rounded(random_.in(low, high)); }
    double decades(double low, double high) { return rounded(std::pow(10.0, random_.in(low, high))); }
    Vector3 vector(double length) {
        Vector3 v;
        for (double& component : v) component = in(-length, length);
        return v;
    }

    // To four digits, so that a failing scene is readable.
    static double rounded(double value) {
        char text[32];
        std::snprintf(text, sizeof text, "%.4g", value);
        return std::strtod(text, nullptr);
    }

    void add_surroundings() {
        if (chance(0.8))
            scene_.gravity = chance(0.8) ? Vector3(0, -10, 0) : vector(20);
        else
            scene_.gravity = Vector3::Zero();
        if (chance(0.5)) scene_.bodies.push_back({.name = "ground", .shape = demos::PlaneShape{}});
        if (chance(0.3)) {
            BodyDescription block{.name = "block", .shape = demos::BoxShape{Vector3::Constant(4 * size_)}};
            block.position = vector(4 * size_);
            block.orientation = random_.rotation();
            scene_.bodies.push_back(block);
        }
        if (chance(0.1)) scene_.bodies.push_back({.name = "stone", .shape = demos::SphereShape{size_}});
    }

    void add_body(int number) {
        BodyDescription body{.name = "body " + std::to_string(number + 1)};
        std::vector<Vector3> points;
        const double size = wild_ ? decades(-3, 3) : rounded(size_ * in(0.5, 2.0));
        if (chance(0.4)) {
            body.shape = demos::SphereShape{size};
        } else {
            Vector3 edges = Vector3::Constant(size);
            if (chance(0.7)) edges = edges.cwiseProduct(positive(chance(0.1) ? 2.0 : 0.5));
            body.shape = demos::BoxShape{edges};
            points = maybe_points(edges);
        }
        body.mass = wild_ || chance(0.2) ? decades(-4, 4) : rounded(mass_ * in(0.5, 2.0));
        body.position = chance(0.05) && number > 0 ? scene_.bodies.back().position : vector(size_ * spread_);
        if (chance(0.7)) body.orientation = random_.rotation();
        if (chance(0.8)) body.velocity = vector(speed_ * size_);
        if (chance(0.6)) body.angular_velocity = vector(speed_);
        body.friction = chance(0.3) ? 0.0 : in(0, 1.5);
        if (chance(0.2)) body.restitution = chance(0.5) ? 1.0 : in(0, 1);
        if (chance(0.05)) {
            body.surface_velocity = vector(size_);
            if (chance(0.3)) body.surface_from = in(0.0, 1.0);
        }
        if (!points.empty()) become_polyhedron(body, points);
        scene_.bodies.push_back(body);
    }

    // Sometimes, points in a box. From numbers of their own, so that all else of a seed stays what it is.
    std::vector<Vector3> maybe_points(const Vector3& edges) {
        std::vector<Vector3> points;
        if (shapes_.in(0, 1) > 0.3) return points;
        const auto count = static_cast<std::size_t>(shapes_.in(5, 25));
        while (points.size() < count) {
            Vector3 point = 0.5 * shapes_.vector(-1, 1).cwiseProduct(edges);
            for (double& number : point) number = rounded(number);
            points.push_back(point);
        }
        return points;
    }

    // Unless the points are too flat.
    static void become_polyhedron(BodyDescription& body, const std::vector<Vector3>& points) {
        try {
            give_polyhedron(body, demos::make_polyhedron(points));
        } catch (const engine::InvalidInput&) {
        }
    }

    demos::MotionDescription motion() {
        demos::MotionDescription motion;
        if (chance(0.3)) {
            motion.kind = demos::ShakingMotion{.amplitude = rounded(size_ * decades(-2, 0.5)),
                                               .direction = vector(1.0) + Vector3(0, 2, 0),
                                               .frequency = decades(-1, 2),
                                               .phase = in(-180, 180)};
        } else if (chance(0.3)) {
            std::vector<demos::TimedPose> poses;
            for (double time = 0.0; poses.size() < 3;) {
                time += in(0.01, 0.3);
                poses.push_back({.time = time, .position = vector(2 * size_)});
                if (chance(0.5)) poses.back().orientation = random_.rotation();
            }
            motion.kind = poses;
            return motion;
        } else {
            motion.kind = demos::SteadyMotion{chance(0.7) ? vector(size_ * decades(-1, 2)) : Vector3::Zero(),
                                              chance(0.5) ? vector(decades(-1, 2)) : Vector3::Zero()};
        }
        if (chance(0.3)) motion.from = in(0.0, 0.3);
        if (chance(0.3)) motion.until = motion.from + in(0.0, 0.3);
        return motion;
    }

    // Three factors, up to `decades_each_way` decades from 1.
    Vector3 positive(double decades_each_way) {
        Vector3 v;
        for (double& component : v) component = decades(-decades_each_way, decades_each_way);
        return v;
    }

    demos::DistanceDescription::End end(const std::string& name, bool at_centre) {
        return {.body = name, .point = at_centre ? Vector3::Zero() : vector(size_)};
    }

    Vector3 world_point(const demos::DistanceDescription::End& end) const {
        const auto body = std::find_if(scene_.bodies.begin(), scene_.bodies.end(),
                                       [&](const BodyDescription& b) { return b.name == end.body; });
        if (body == scene_.bodies.end()) return end.point;
        return body->position + body->orientation * end.point;
    }

    // A given length, or none: the distance of the points at the start.
    bool has_length(const demos::DistanceDescription& distance) const {
        if (distance.length) return *distance.length > 0.0;
        return (world_point(distance.a) - world_point(distance.b)).norm() > 1e-3 * size_;
    }

    void add_distances(bool isolated) {
        const std::size_t bodies = scene_.bodies.size();
        const std::size_t count = 1 + below(6);
        for (std::size_t i = 0; i < count; ++i) {
            const BodyDescription& a = scene_.bodies[below(bodies)];
            const BodyDescription& b = scene_.bodies[below(bodies)];
            const bool to_world = !isolated && chance(0.3);
            const bool between_static = !b.mass && (to_world || !a.mass);
            if (between_static || (!to_world && a.name == b.name)) continue;
            demos::DistanceDescription distance;
            distance.a = end(to_world ? "world" : a.name, chance(0.3));
            distance.b = end(b.name, chance(0.3));
            if (chance(0.4)) distance.length = chance(0.1) ? 0.0 : rounded(size_ * decades(-1, 1));
            if (chance(0.3))
                distance.acts = chance(0.5) ? engine::Distance::Acts::pulls : engine::Distance::Acts::pushes;
            if (chance(0.1)) distance.max_force = decades(-3, 4);
            if (!has_length(distance)) distance = {.a = distance.a, .b = distance.b, .length = 0.0};
            scene_.distances.push_back(distance);
            // The same bar once more, or one that contradicts it.
            if (chance(0.2)) scene_.distances.push_back(distance);
            if (chance(0.1)) {
                distance.length = rounded(size_ * decades(-1, 1));
                scene_.distances.push_back(distance);
            }
        }
    }

    void add_force() {
        demos::ForceDescription force{.body = scene_.bodies.back().name, .force = vector(mass_ * decades(-1, 3))};
        if (chance(0.5)) force.until = 0.1;
        scene_.forces.push_back(force);
    }

    void soften_distances() {
        for (demos::DistanceDescription& distance : scene_.distances) {
            const bool rigid = distance.max_force || distance.acts != engine::Distance::Acts::both;
            if (rigid || !has_length(distance) || chance(0.3)) continue;
            distance.spring = engine::Spring{mass_ * decades(-1, 5), chance(0.5) ? mass_ * decades(-2, 3) : 0.0};
        }
    }

    void add_joints(bool isolated) {
        const std::size_t bodies = scene_.bodies.size(), count = 1 + below(4);
        for (std::size_t i = 0; i < count; ++i) {
            const BodyDescription &a = scene_.bodies[below(bodies)], &b = scene_.bodies[below(bodies)];
            const bool to_world = !isolated && chance(0.3);
            if ((!b.mass && (to_world || !a.mass)) || (!to_world && a.name == b.name)) continue;
            demos::JointDescription joint;
            joint.a = end(to_world ? "world" : a.name, chance(0.3));
            joint.b = end(b.name, chance(0.3));
            joint.collide = chance(0.3);
            if (chance(0.8)) {
                joint.hinge.emplace().axis = vector(1.0) + Vector3(0.1, 0, 0);
                if (chance(0.3)) joint.hinge->zero = random_.rotation();
                if (chance(0.4)) joint.hinge->motor = engine::Motor{.speed = in(-10, 10)};
                if (joint.hinge->motor && chance(0.8)) joint.hinge->motor->max_torque = mass_ * decades(-2, 3);
                if (chance(0.4)) joint.hinge->limits = engine::AngleLimits{in(-2, 0), in(0, 2)};
            }
            scene_.joints.push_back(joint);
        }
    }

    void turn_forces() {
        for (demos::ForceDescription& force : scene_.forces) {
            if (chance(0.5)) force.torque = size_ * vector(mass_ * decades(-1, 3));
            if (chance(0.5)) force.point = vector(size_);
            if (chance(0.5)) force.frame = engine::Poke::Frame::body;
        }
    }

    // Bodies that do not touch each other, and what materials have on each other.
    void add_pairs() {
        for (BodyDescription& body : scene_.bodies) {
            if (chance(0.3)) body.group = "group";
            if (chance(0.5)) body.material = chance(0.5) ? "ice" : "rubber";
        }
        const auto is_used = [&](const char* name) {
            return std::any_of(scene_.bodies.begin(), scene_.bodies.end(),
                               [&](const BodyDescription& body) { return body.material == name; });
        };
        for (const auto& [a, b] : {std::pair{"ice", "ice"}, std::pair{"ice", "rubber"}}) {
            if (!is_used(a) || !is_used(b)) continue;
            scene_.materials.push_back({.a = a, .b = b, .friction = in(0, 1)});
            if (chance(0.3)) scene_.materials.back().restitution = in(0, 1);
        }
        const BodyDescription &a = scene_.bodies.front(), &b = scene_.bodies.back();
        if (a.name != b.name) scene_.no_contacts.emplace_back(a.name, b.name);
    }

    void add_options() {
        constexpr std::array presets{"default", "exact", "paper"};
        constexpr std::array steps_a_second{60, 60, 60, 30, 240, 10};
        scene_.options["preset"] = presets[below(presets.size())];
        // Not auto: joints that contradict each other, which many of these scenes have, ask for ever more.
        scene_.options["substeps"] = "1";
        const int rate = steps_a_second[below(steps_a_second.size())];
        if (rate != 60) scene_.options["dt"] = "1/" + std::to_string(rate);
        scene_.options["seconds"] = demos::to_text(30.0 / rate);
        if (chance(0.3)) return;
        for (const OptionChoices& option : option_choices) {
            const std::string text = option.texts[below(option.texts.size())];
            if (!text.empty() && chance(0.5)) scene_.options[option.name] = text;
        }
    }

    Random random_, shapes_;
    SceneDescription scene_;
    double size_ = 1.0;    // m, of most bodies
    double mass_ = 1.0;    // kg, of most bodies
    bool wild_ = false;    // each body has a size and a mass of its own, decades apart
    double spread_ = 1.0;  // how far the bodies are from the origin, in sizes
    double speed_ = 0.0;   // sizes/s and rad/s
};

}  // namespace

SceneDescription random_scene(std::uint64_t seed) {
    return Generator(seed).make();
}

demos::Settings settings_of(const SceneDescription& scene) {
    const auto given = scene.options.find("preset");
    demos::Settings settings = demos::preset_settings(given == scene.options.end() ? "default" : given->second);
    for (const demos::SimulationOption& option : demos::simulation_options()) {
        const auto chosen = scene.options.find(std::string(option.name));
        if (chosen == scene.options.end() || option.set(settings, chosen->second)) continue;
        throw std::invalid_argument(chosen->first + " " + chosen->second + ": must be " + option.allowed);
    }
    return settings;
}

}  // namespace pushfactor::tests
