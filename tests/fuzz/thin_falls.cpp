#include "tests/fuzz/thin_falls.h"

#include "demos/base/text/numbers.h"
#include "demos/runs/simulation.h"
#include "tests/fuzz/random_scene.h"
#include "tests/fuzz/solid_distance.h"
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

constexpr std::array pieces{"rod", "plate", "coin"};
constexpr std::array targets{"ground", "static", "movable"};
constexpr double greatest_height = 3.0, gravity = 10.0;

// Corners of a prism about the y axis.
std::vector<Vector3> prism_points(int sides, double radius, double height) {
    std::vector<Vector3> points;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        for (const double y : {-0.5, 0.5}) {
            points.emplace_back(radius * std::cos(angle), y * height, radius * std::sin(angle));
        }
    }
    return points;
}

class FallDraw {
  public:
    FallDraw(std::size_t kind, std::uint64_t seed) : random_(100 * seed + kind), kind_(kind) {}

    ThinFall make() {
        ThinFall fall{.kind = kind_, .scene = {}};
        fall.scene.contacts = true;
        fall.scene.gravity = {0, -gravity, 0};
        const double friction = random_.in(0, 0.8), seconds = std::sqrt(2.0 * greatest_height / gravity) + 1.5;
        fall.scene.options = {{"threads", "1"}, {"seconds", demos::to_text(seconds)}};
        fall.scene.bodies = {{.name = "ground", .shape = demos::PlaneShape{}}, piece()};
        double top = 0.0;
        if (kind_ % targets.size() > 0) {
            fall.scene.bodies.push_back(target(kind_ % targets.size() == 2));
            top = height_of(fall.scene.bodies.back());
        }
        BodyDescription& falling = fall.scene.bodies[1];
        const double height = random_.in(0.0, greatest_height);
        const Vector3 aside = random_.vector(-0.5, 0.5);
        falling.position = {aside.x(), top + height + 1e-3 + 0.5 * extent_of(falling), aside.z()};
        for (BodyDescription& body : fall.scene.bodies) body.friction = friction;
        fall.thickness = solid_of(falling).size;
        return fall;
    }

  private:
    bool chance(double share) { return random_.in(0, 1) < share; }

    BodyDescription piece() {
        BodyDescription body{.name = "piece", .mass = 1.0};
        const double thickness = random_.in(0.02, 0.1);
        switch (kind_ / targets.size()) {
            case 0:
                body.shape = demos::BoxShape{{random_.in(0.7, 1.5), thickness, thickness}};
                break;
            case 1: {
                const Vector3 edges = random_.vector(0.5, 1.2);
                body.shape = demos::BoxShape{{edges.x(), thickness, edges.z()}};
                break;
            }
            default:
                give_polyhedron(body, demos::make_polyhedron(prism_points(corners(), 0.5, thickness)));
        }
        const Quaternion frame = body.orientation;
        body.orientation = (chance(0.5) ? random_.rotation() : nearly_flat()) * frame;
        if (chance(0.5)) body.angular_velocity = random_.vector(-5, 5);
        return body;
    }

    int corners() { return static_cast<int>(8.0 * std::pow(16.0, random_.in(0.0, 1.0))); }

    Quaternion nearly_flat() {
        const double direction = random_.in(-3.1, 3.1), angle = random_.in(0.0, 20.0) * std::numbers::pi / 180.0;
        return Quaternion(Eigen::AngleAxisd(angle, Vector3(std::cos(direction), 0, std::sin(direction))));
    }

    // Movable ones lie on the ground.
    BodyDescription target(bool is_movable) {
        BodyDescription body{.name = "target"};
        const Vector3 size = random_.vector(0.5, 1.5);
        if (chance(0.5)) {
            body.shape = demos::BoxShape{size};
        } else {
            const int sides = static_cast<int>(random_.in(3, 9));
            give_polyhedron(body, demos::make_polyhedron(prism_points(sides, 0.5 * size.x(), size.y())));
        }
        const Quaternion frame = body.orientation;
        const double turn = random_.in(-3.1, 3.1);
        body.orientation = Quaternion(Eigen::AngleAxisd(turn, Vector3::UnitY())) * frame;
        if (is_movable) {
            body.mass = 10.0;
        } else {
            body.orientation = random_.rotation();
        }
        body.position = {0, 0.5 * extent_of(body), 0};
        if (!is_movable) body.position.y() += random_.in(0.0, 0.5);
        return body;
    }

    // m, twice how far it reaches above or below its centre.
    static double extent_of(const BodyDescription& body) {
        double most = 0.0;
        for (const Vector3& point : solid_of(body).points) {
            most = std::max(most, std::abs((body.orientation * point).y()));
        }
        return 2.0 * most;
    }

    static double height_of(const BodyDescription& body) { return body.position.y() + 0.5 * extent_of(body); }

    Random random_;
    std::size_t kind_;
};

// m, how deep the piece is in the ground or in the target.
double overlap_of_piece(const std::vector<Solid>& solids, std::span<const Body> bodies) {
    const PlacedSolid piece(solids[1], bodies[1].position, bodies[1].orientation);
    double deepest = 0.0;
    for (const Vector3& point : piece.points) deepest = std::max(deepest, -point.y());
    if (solids.size() < 3) return deepest;
    const PlacedSolid target(solids[2], bodies[2].position, bodies[2].orientation);
    const double apart =
        (target.position - piece.position).norm() - solids[1].turning_radius - solids[2].turning_radius;
    return apart > 0.0 ? deepest : std::max(deepest, -closeness(piece, target).distance);
}

std::string kind_name(std::size_t kind) {
    return fmt::format("{} on {}", pieces[kind / targets.size()], targets[kind % targets.size()]);
}

std::string fall_line(const std::string& name, std::vector<double> depths, long failed) {
    std::sort(depths.begin(), depths.end());
    return fmt::format("{:<18}{:>7}{:>8}{:>10.3f}{:>10.3f}\n", name, depths.size(), failed,
                       depths[depths.size() / 2], depths.back());
}

}  // namespace

std::vector<std::string> thin_fall_kinds() {
    std::vector<std::string> names;
    for (std::size_t kind = 0; kind < pieces.size() * targets.size(); ++kind) names.push_back(kind_name(kind));
    return names;
}

ThinFall draw_thin_fall(std::size_t kind, std::uint64_t seed) {
    ThinFall fall = FallDraw(kind, seed).make();
    fall.scene.name =
        fmt::format("{}-on-{}-{}", pieces[kind / targets.size()], targets[kind % targets.size()], seed);
    return fall;
}

JudgedFall judge_thin_fall(const ThinFall& fall, const std::string& preset) {
    JudgedFall judged{.fall = fall};
    judged.fall.scene.options["preset"] = preset;
    try {
        const demos::Settings settings = settings_of(judged.fall.scene);
        demos::Simulation simulation(build_scene(judged.fall.scene, settings), settings);
        std::vector<Solid> solids;
        for (const BodyDescription& body : fall.scene.bodies) solids.push_back(solid_of(body));
        for (long step = 1; step <= whole_steps(settings); ++step) {
            simulation.advance();
            const double deep = overlap_of_piece(solids, simulation.scene().world.bodies) / fall.thickness;
            if (deep <= judged.deepest) continue;
            judged.deepest = deep;
            judged.step = step;
        }
    } catch (const std::exception& error) {
        judged.error = error.what();
    }
    return judged;
}

std::vector<JudgedFall> judge_thin_falls(long count, std::uint64_t first_seed, const std::string& preset,
                                         const GoOn& go_on) {
    const auto kinds = static_cast<long>(thin_fall_kinds().size());
    return results_of<JudgedFall>(
        count,
        [&](long i) {
            return judge_thin_fall(draw_thin_fall(static_cast<std::size_t>(i % kinds),
                                                  first_seed + static_cast<std::uint64_t>(i / kinds)),
                                   preset);
        },
        go_on);
}

std::string thin_fall_table(const std::vector<JudgedFall>& judged) {
    std::string text =
        fmt::format("{:<18}{:>7}{:>8}{:>10}{:>10}\n", "thicknesses", "falls", "failed", "median", "worst");
    const std::vector<std::string> names = thin_fall_kinds();
    std::vector<double> all;
    long all_failed = 0;
    for (std::size_t kind = 0; kind < names.size(); ++kind) {
        std::vector<double> depths;
        long failed = 0;
        for (const JudgedFall& one : judged) {
            if (one.fall.kind != kind) continue;
            depths.push_back(one.deepest);
            failed += one.holds() ? 0 : 1;
        }
        if (depths.empty()) continue;
        text += fall_line(names[kind], depths, failed);
        all.insert(all.end(), depths.begin(), depths.end());
        all_failed += failed;
    }
    return all.empty() ? text : text + fall_line("all", all, all_failed);
}

}  // namespace pushfactor::tests
