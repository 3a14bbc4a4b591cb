#include "tests/fuzz/structures.h"

#include "demos/runs/measurements.h"
#include "demos/runs/simulation.h"
#include "tests/fuzz/random_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace pushfactor::tests {

namespace {

using demos::BodyDescription;
using demos::families::Ends;
using demos::families::Member;
using demos::families::Prospect;
using engine::Body;
using engine::Vector3;

// Limits. Standing bodies may overlap only slightly; dropped ones land deeper.
constexpr double most_energy = 1e-3;
constexpr double most_overlap_standing = 0.1, most_overlap_moving = 0.5;
constexpr double most_speed = 0.02;
constexpr double most_moved = 0.05, least_moved = 0.2;
constexpr double most_step = 40.0, most_step_standing = 200.0;
// Multiply-adds of a usual step per movable body: some 30 sweeps over a dozen rows; and in total, some tenths of a
// millisecond, below which no step counts as slow.
constexpr double usual_work = 1e4, least_work = 3e5;

double volume(const BodyDescription& body) {
    return std::visit(engine::Overloaded{[](const demos::BoxShape& box) { return box.size.prod(); },
                                         [](const demos::SphereShape& ball) {
                                             return 4.0 / 3.0 * std::numbers::pi * std::pow(ball.radius, 3);
                                         },
                                         [](const demos::PlaneShape&) { return engine::infinity; },
                                         [](const demos::PolyhedronShape& hull) { return hull.volume; }},
                      body.shape);
}

// Of a polyhedron the shortest distance between two corners.
double shortest_edge(const BodyDescription& body) {
    const auto of_points = [](std::span<const Vector3> points) {
        double shortest = INFINITY;
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) shortest = std::min(shortest, (points[i] - points[j]).norm());
        }
        return shortest;
    };
    return std::visit(
        engine::Overloaded{[](const demos::BoxShape& box) { return box.size.minCoeff(); },
                           [](const demos::SphereShape& ball) { return 2.0 * ball.radius; },
                           [](const demos::PlaneShape&) { return engine::infinity; },
                           [&](const demos::PolyhedronShape& hull) { return of_points(hull.points()); }},
        body.shape);
}

bool is_ball(const BodyDescription& body) {
    return std::holds_alternative<demos::SphereShape>(body.shape);
}

// The units of a member's numbers.
struct Scale {
    double length = INFINITY, edge = INFINITY;  // m
    double weight = 0.0;                        // N
    double speed = 0.0;                         // m/s

    explicit Scale(const demos::SceneDescription& scene) {
        for (const BodyDescription& body : scene.bodies) {
            if (!body.mass) continue;
            length = std::min(length, std::cbrt(volume(body)));
            edge = std::min(edge, shortest_edge(body));
            weight += *body.mass * scene.gravity.norm();
        }
        speed = std::sqrt(scene.gravity.norm() * length);
    }
};

// Looks at the steps of one run.
class Watch {
  public:
    Watch(const Prospect& prospect, const demos::Simulation& simulation)
        : prospect_(prospect), simulation_(simulation), scale_(prospect.scene) {
        start_ = simulation.scene().world.bodies;
        for (const BodyDescription& body : prospect.scene.bodies) {
            if (!body.mass) continue;
            movable_ += 1.0;
            balls_alone_ = balls_alone_ && is_ball(body);
        }
    }

    void observe() {
        const demos::Sample& sample = simulation_.sample();
        gain_ = std::max(gain_, sample.energy_gain);
        deepest_ = std::max(deepest_, sample.penetration.max);
        if (sample.count.multiply_adds > 0.0) work_.push_back(sample.count.multiply_adds);
        const bool last_second = sample.time > prospect_.rest_by;
        for (std::size_t i = 0; i < start_.size(); ++i) {
            if (!start_[i].is_static()) observe(i, last_second);
        }
    }

    void judge(Judgement& judgement) const {
        const bool stands = prospect_.ends == Ends::stands;
        judgement[Property::ground] = {below_ / scale_.length, 0.0};
        judgement[Property::energy] = {gain_ / (scale_.weight * scale_.length), most_energy};
        judgement[Property::overlap] = {deepest_ / scale_.edge,
                                        stands ? most_overlap_standing : most_overlap_moving};
        judgement[Property::rest] = {fastest_ / scale_.speed, most_speed, false, !prospect_.stirred};
        judgement[Property::ends] = {stands ? most_movement() : least_leaving(), stands ? most_moved : least_moved,
                                     !stands, prospect_.ends != Ends::rests};
        const double worst = work_.empty() ? 0.0 : *std::max_element(work_.begin(), work_.end());
        judgement[Property::step] = {worst / std::max({demos::median(work_), usual_work * movable_, least_work}),
                                     stands ? most_step_standing : most_step};
    }

  private:
    void observe(std::size_t i, bool last_second) {
        const Body& body = simulation_.scene().world.bodies[i];
        const BodyDescription& described = prospect_.scene.bodies[i];
        if (last_second && (balls_alone_ || !is_ball(described))) {
            fastest_ = std::max(fastest_, velocity(body).norm());
        }
        for (const BodyDescription& plane : prospect_.scene.bodies) {
            if (!std::holds_alternative<demos::PlaneShape>(plane.shape)) continue;
            const double height = (plane.orientation * Vector3::UnitY()).dot(body.position - plane.position);
            below_ = std::max(below_, -height);
        }
    }

    double moved(std::size_t i) const {
        return (simulation_.scene().world.bodies[i].position - start_[i].position).norm() / scale_.length;
    }

    double turned(std::size_t i) const {
        return simulation_.scene().world.bodies[i].orientation.angularDistance(start_[i].orientation);
    }

    double most_movement() const {
        double most = 0.0;
        for (std::size_t i = 0; i < start_.size(); ++i) most = std::max(most, moved(i));
        return most;
    }

    double least_leaving() const {
        const std::set<std::string> leaving(prospect_.leaving.begin(), prospect_.leaving.end());
        double least = INFINITY;
        for (std::size_t i = 0; i < start_.size(); ++i) {
            if (!leaving.contains(prospect_.scene.bodies[i].name)) continue;
            least = std::min(least, prospect_.ends == Ends::topples ? turned(i) : moved(i));
        }
        return least;
    }

    const Prospect& prospect_;
    const demos::Simulation& simulation_;
    Scale scale_;
    double movable_ = 0.0;  // how many bodies
    bool balls_alone_ = true;
    std::vector<Body> start_;
    double gain_ = 0.0, deepest_ = 0.0, below_ = 0.0, fastest_ = 0.0;  // J, m, m, m/s
    std::vector<double> work_;                                         // multiply-adds, one per step
};

}  // namespace

bool Judgement::holds() const {
    return std::all_of(of.begin(), of.end(), [](const Measured& measured) { return measured.holds(); });
}

demos::SceneDescription as_judged(const Member& member, const std::string& preset) {
    demos::SceneDescription scene = member.prospect.scene;
    scene.options["preset"] = preset;
    scene.options["rest"] = "off";  // what stands has to, awake
    return scene;
}

Judgement judge_run(const Prospect& prospect, const demos::SceneDescription& scene) {
    Judgement judgement;
    try {
        const demos::Settings settings = settings_of(scene);
        demos::Simulation simulation(build_scene(scene, settings), settings);
        Watch watch(prospect, simulation);
        for (long step = 0; step < whole_steps(settings); ++step) {
            simulation.advance();
            watch.observe();
        }
        watch.judge(judgement);
    } catch (const std::exception& error) {
        judgement.error = error.what();
        judgement[Property::finite].value = 1.0;
    }
    return judgement;
}

Judgement judge_member(const Member& member, const std::string& preset) {
    Judgement judgement = judge_run(member.prospect, as_judged(member, preset));
    if (preset != "paper") return judgement;
    for (std::size_t i = 1; i < judgement.of.size(); ++i) judgement.of[i].asked = false;
    return judgement;
}

}  // namespace pushfactor::tests
