#include "tests/fuzz/meetings.h"

#include "demos/base/text/numbers.h"
#include "demos/runs/scene.h"
#include "engine/base/invalid_input.h"
#include "tests/fuzz/random_scene.h"
#include "tests/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pushfactor::tests {

namespace {

using demos::BodyDescription;
using engine::Body;
using engine::Quaternion;
using engine::Vector3;

constexpr std::array piece_names{"box", "ball", "polyhedron", "rod"};
constexpr double dt = 1.0 / 60.0;  // s
constexpr long run_steps = 10;
constexpr double kept = 1e-9;          // of m v and m v r
constexpr double normal_angle = 5e-3;  // rad

std::vector<std::pair<std::size_t, std::size_t>> pairs_of_pieces() {
    std::vector<std::pair<std::size_t, std::size_t>> all;
    for (std::size_t a = 0; a < piece_names.size(); ++a) {
        for (std::size_t b = a; b < piece_names.size(); ++b) all.emplace_back(a, b);
    }
    return all;
}

class Draw {
  public:
    Draw(std::size_t kind, std::uint64_t seed) : random_(seed), kind_(kind) {}

    // A pair whose closest approach or first touch is planned with the motion `steady`; whether it comes out is for
    // predict() to say.
    Meeting plan(Prediction::Kind wanted) {
        Meeting meeting{.kind = kind_, .scene = {}, .steps = run_steps, .prediction = {}};
        meeting.scene.gravity = Vector3::Zero();
        meeting.scene.contacts = true;
        meeting.scene.options = {{"threads", "1"}};
        const auto [first, second] = pairs_of_pieces()[kind_];
        const bool is_swapped = chance(0.5);
        meeting.scene.bodies = {piece("a", is_swapped ? second : first), piece("b", is_swapped ? first : second)};
        meeting.speed = by_decades(0.3, 200.0);
        const Vector3 relative = meeting.speed * direction();
        set_motions(meeting.scene, relative);
        make_bodies(meeting.scene);
        if (wanted == Prediction::Kind::passes) {
            place_passing(relative, by_decades(1e-4, 5e-2));
        } else if (chance(0.5)) {
            place_passing(relative, -by_decades(1e-4, 0.1));
        } else {
            place_touching(relative);
        }
        for (std::size_t i = 0; i < 2; ++i) {
            meeting.scene.bodies[i].position = pair_[i].body.position;
        }
        return meeting;
    }

    Prediction prediction() const { return predict(pair_[0], pair_[1], dt, run_steps); }

  private:
    bool chance(double share) { return random_.in(0, 1) < share; }
    double by_decades(double low, double high) { return std::exp(random_.in(std::log(low), std::log(high))); }
    Vector3 direction() { return random_.rotation() * Vector3::UnitX(); }

    BodyDescription piece(const char* name, std::size_t which) {
        BodyDescription body{.name = name, .mass = by_decades(0.2, 5.0)};
        const double size = by_decades(0.1, 1.0);
        switch (which) {
            case 0:
                body.shape = demos::BoxShape{size * random_.vector(0.3, 1.0)};
                break;
            case 1:
                body.shape = demos::SphereShape{0.5 * size};
                break;
            case 2:
                give_polyhedron(body, polyhedron(size));
                break;
            default: {
                const Vector3 thickness = 2.0 * size * random_.vector(0.025, 0.1);
                body.shape = demos::BoxShape{{2.0 * size, thickness.y(), thickness.z()}};
            }
        }
        body.orientation = random_.rotation();
        body.friction = 0.0;
        return body;
    }

    // A prism, or the hull of random points.
    demos::FramedPolyhedron polyhedron(double size) {
        for (;;) {
            try {
                return demos::make_polyhedron(chance(0.3) ? prism(size) : cloud(size));
            } catch (const engine::InvalidInput&) {
            }
        }
    }

    std::vector<Vector3> prism(double size) {
        std::vector<Vector3> points;
        const int corners = static_cast<int>(random_.in(3, 13));
        const double half = 0.5 * size * random_.in(0.1, 1.0);
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / corners;
            for (const double y : {-half, half}) {
                points.emplace_back(0.5 * size * std::cos(angle), y, 0.5 * size * std::sin(angle));
            }
        }
        return points;
    }

    std::vector<Vector3> cloud(double size) {
        const Vector3 edges = size * random_.vector(0.3, 1.0);
        std::vector<Vector3> points(static_cast<std::size_t>(random_.in(4, 17)));
        for (Vector3& point : points) point = 0.5 * direction().cwiseProduct(edges);
        return points;
    }

    void set_motions(demos::SceneDescription& scene, const Vector3& relative) {
        BodyDescription &a = scene.bodies[0], &b = scene.bodies[1];
        const bool is_static = chance(0.25);
        const double share = is_static ? 1.0 : random_.in(0, 1);
        Vector3 common = Vector3::Zero();
        if (!is_static && chance(0.5)) common = by_decades(0.1, 100.0) * direction();
        a.velocity = common - share * relative;
        b.velocity = common + (1.0 - share) * relative;
        if (is_static) b.mass.reset();
        for (BodyDescription& body : scene.bodies) {
            if (body.mass && chance(0.7)) body.angular_velocity = spin(body);
        }
    }

    // About a principal axis in half of the cases.
    Vector3 spin(const BodyDescription& body) {
        const double rate = by_decades(0.1, 10.0) / bounding_radius(body);
        const auto axis = static_cast<int>(random_.in(0, 3));
        return rate * (chance(0.5) ? Vector3(body.orientation * Vector3::Unit(axis)) : direction());
    }

    void make_bodies(const demos::SceneDescription& scene) {
        const demos::BuiltScene built = build_scene(scene, settings_of(scene));
        for (std::size_t i = 0; i < 2; ++i) {
            solids_[i] = solid_of(scene.bodies[i]);
            pair_[i] = {&solids_[i], built.world.bodies[i]};
        }
    }

    double reach() const { return pair_[0].reach() + pair_[1].reach(); }

    // s, of the closest approach or of the touch.
    double when() { return dt * random_.in(0.02, 8.0); }

    Vector3 across(const Vector3& relative) { return relative.cross(direction()).normalized(); }

    // b passes a at `time` with the distance `level` [m], or as near to that as its start allows: of the places
    // along a line across the motion the one where it still does not come closer.
    void place_passing(const Vector3& relative, double level) {
        const double time = when();
        const Vector3 shift = across(relative), start = pair_[0].body.position - time * relative;
        double clear = reach() + std::abs(level) + 0.01, close = 0.0;
        while (clear - close > 1e-2 * std::abs(level)) {
            const double middle = 0.5 * (clear + close);
            pair_[1].body.position = start + middle * shift;
            (stays_above(level, pair_[0], pair_[1], dt, run_steps, Turning::steady) ? clear : close) = middle;
        }
        pair_[1].body.position = start + clear * shift;
    }

    // b comes along its motion and touches a at some time. Orientations of that time do not depend on where they
    // are.
    void place_touching(const Vector3& relative) {
        const double time = when();
        for (FreeBody& body : pair_) body.body.position.setZero();
        std::array<FreeBody, 2> then = pair_;
        for (FreeBody& body : then) {
            double left = time;
            for (; left > dt; left -= dt) body.body = moved(body.body, dt, dt, Turning::torque_free);
            body.body = moved(body.body, left, dt, Turning::steady);
            body.body.position.setZero();
        }
        const Vector3 back = -relative.normalized(), side = across(relative);
        double before = 0.0;
        Vector3 offset;
        do {
            offset = random_.in(0.0, reach()) * side;
            before = way_back(then, offset, back);
        } while (before < -reach());
        pair_[1].body.position = offset + before * back - time * relative;
    }

    // m, how far back from `offset` b touches a; less than minus the reach if it misses.
    double way_back(std::array<FreeBody, 2> pair, const Vector3& offset, const Vector3& back) const {
        double way = 1.1 * reach();
        while (way >= -reach()) {
            pair[1].body.position = offset + way * back;
            const double distance = closeness(pair[0].placed(), pair[1].placed()).distance;
            if (distance < 1e-7) break;
            way -= distance;
        }
        return way;
    }

    Random random_;
    std::size_t kind_;
    std::array<Solid, 2> solids_;
    std::array<FreeBody, 2> pair_;
};

struct Change {
    double of_momentum = 0.0, of_angular_momentum = 0.0;  // in m v and m v r

    double largest() const { return std::max(of_momentum, of_angular_momentum); }
};

Change change_of(const std::vector<Body>& before, const std::vector<Body>& now, const Meeting& meeting) {
    Change most;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i].is_static()) continue;
        const double unit = before[i].mass() * meeting.speed, r = bounding_radius(meeting.scene.bodies[i]);
        most.of_momentum =
            std::max(most.of_momentum, (now[i].linear_momentum - before[i].linear_momentum).norm() / unit);
        most.of_angular_momentum = std::max(
            most.of_angular_momentum, (now[i].angular_momentum - before[i].angular_momentum).norm() / (unit * r));
    }
    return most;
}

// rad, from the row, or the row with a force, that is closest to `normal`; infinity without one.
double angle_to(const Vector3& normal, const demos::BuiltScene& scene, bool with_force) {
    double least = engine::infinity;
    for (const engine::ContactSite& site : scene.contacts->sites()) {
        const double force = scene.world.lambda().row(static_cast<Eigen::Index>(site.normal_row)).maxCoeff();
        if (with_force && force <= 0.0) continue;
        const Vector3 along = site.body_a == 0 ? site.normal : -site.normal;
        least = std::min(least, std::atan2(along.cross(normal).norm(), along.dot(normal)));
    }
    return least;
}

MeetingVerdict judge_touch(const Meeting& meeting, const demos::BuiltScene& scene, const Change& change) {
    const Prediction& wanted = meeting.prediction;
    if (change.largest() <= kept) return {MeetingFault::missed, "no force in the step of the touch", wanted.step};
    if (!wanted.normal) return {};
    const double allowed = normal_angle + (wanted.in_margin ? wanted.turned : 0.0);
    const double angle = angle_to(*wanted.normal, scene, true);
    if (angle <= allowed) return {.step = wanted.step, .worst = angle};
    const bool unused = angle_to(*wanted.normal, scene, false) <= allowed;
    return {unused ? MeetingFault::unused_normal : MeetingFault::wrong_normal,
            fmt::format("normal off by {:.2g} rad{}", angle, unused ? ", the right row has no force" : ""),
            wanted.step, angle};
}

MeetingVerdict run(const Meeting& meeting, const demos::SceneDescription& described) {
    demos::BuiltScene scene = build_scene(described, settings_of(described));
    const std::vector<Body> start = scene.world.bodies;
    MeetingVerdict verdict;
    for (long step = 1; step <= meeting.steps; ++step) {
        scene.step(scene.world, dt);
        const Change change = change_of(start, scene.world.bodies, meeting);
        if (step == meeting.prediction.step) return judge_touch(meeting, scene, change);
        verdict.worst = std::max(verdict.worst, change.largest());
        if (verdict.worst <= kept) continue;
        verdict.fault = meeting.prediction.step > 0 ? MeetingFault::early : MeetingFault::disturbed;
        verdict.step = step;
        verdict.failure = fmt::format("momentum changed by {:.2g} m v, angular momentum by {:.2g} m v r",
                                      change.of_momentum, change.of_angular_momentum);
        return verdict;
    }
    return verdict;
}

}  // namespace

std::vector<std::string> meeting_kinds() {
    std::vector<std::string> names;
    for (const auto& [a, b] : pairs_of_pieces())
        names.push_back(fmt::format("{}-{}", piece_names[a], piece_names[b]));
    return names;
}

Meeting draw_meeting(Prediction::Kind wanted, std::size_t kind, std::uint64_t seed) {
    const bool passes = wanted == Prediction::Kind::passes;
    for (int attempt = 0;; ++attempt) {
        Draw draw(kind, 1'000'000 * seed + 20 * static_cast<std::uint64_t>(attempt) + 2 * kind + (passes ? 1 : 0));
        Meeting meeting = draw.plan(wanted);
        meeting.prediction = draw.prediction();
        if (meeting.prediction.kind != wanted) continue;
        if (passes) meeting.prediction.step = 0;
        if (!passes) meeting.steps = meeting.prediction.step;
        meeting.left_out = attempt;
        meeting.scene.name = fmt::format("{}-{}-{}", passes ? "passes" : "touches", meeting_kinds()[kind], seed);
        meeting.scene.options["seconds"] = demos::to_text(static_cast<double>(meeting.steps) * dt);
        return meeting;
    }
}

std::array<Body, 2> bodies_of(const Meeting& meeting) {
    const demos::BuiltScene built = build_scene(meeting.scene, settings_of(meeting.scene));
    return {built.world.bodies[0], built.world.bodies[1]};
}

double overlap_of(const Meeting& meeting) {
    auto [a, b] = bodies_of(meeting);
    for (long step = 1; step < meeting.prediction.step; ++step) {
        for (Body* body : {&a, &b}) *body = moved(*body, dt, dt, Turning::torque_free);
    }
    const std::array<Solid, 2> solids{solid_of(meeting.scene.bodies[0]), solid_of(meeting.scene.bodies[1])};
    const PairStep last({&solids[0], a}, {&solids[1], b}, dt, Turning::steady);
    double reached = graze;
    while (reached < 10.0 && last.first_at(-1.1 * reached)) reached *= 1.1;
    return reached;
}

MeetingVerdict judge_meeting(const Meeting& meeting, const std::string& preset) {
    demos::SceneDescription scene = meeting.scene;
    scene.options["preset"] = preset;
    try {
        return run(meeting, scene);
    } catch (const std::exception& error) {
        return {.fault = MeetingFault::refused, .failure = error.what()};
    }
}

}  // namespace pushfactor::tests
