#include "tests/peers/measures.h"

#include "tests/peers/exact.h"
#include "tests/peers/mechanics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pushfactor::tests::peers {

namespace {

constexpr std::size_t second = 60;  // steps
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::size_t last(const Run& run) {
    return run.states.size() - 1;
}

// At the time of the positions, which lies between the velocities of this state and of the next.
double energy(const Scene& scene, const Run& run, std::size_t step) {
    const double before = kinetic(scene, run.states[step]);
    const double after = kinetic(scene, run.states[step + 1]);
    const double lag = run.velocity_lag[step];
    const double share = lag / (1.0 + lag - run.velocity_lag[step + 1]);
    return potential(scene, run.states[step]) + before + share * (after - before);
}

// Corners of one face of a box, world frame; `side` +1: the top in its own frame, -1: the bottom.
std::vector<Vector3> corners(const Body& body, const State& s, double side) {
    std::vector<Vector3> result;
    for (const double x : {-0.5, 0.5}) {
        for (const double z : {-0.5, 0.5})
            result.emplace_back(s.position + s.orientation * body.size.cwiseProduct(Vector3(x, 0.5 * side, z)));
    }
    return result;
}

double depth_of_cubes(const Scene& scene, const std::vector<State>& states) {
    double depth = 0.0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const double half = 0.5 * scene.movable[i].size.y();
        const State& s = states[i];
        for (const Vector3& corner : corners(scene.movable[i], s, -1.0)) {
            const double above =
                i == 0 ? corner.y()
                       : (states[i - 1].orientation.conjugate() * (corner - states[i - 1].position)).y() - half;
            depth = std::max(depth, -above);
        }
        if (i == 0) continue;
        for (const Vector3& corner : corners(scene.movable[i - 1], states[i - 1], 1.0))
            depth = std::max(depth, (s.orientation.conjugate() * (corner - s.position)).y() + half);
    }
    return depth;
}

double depth_of_spheres(const Scene& scene, const std::vector<State>& states) {
    double depth = 0.0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const double radius = scene.movable[i].radius;
        for (const Body& plane : scene.fixed) {
            const Vector3 normal = plane.start.orientation * Vector3::UnitY();
            depth = std::max(depth, radius - normal.dot(states[i].position - plane.start.position));
        }
        for (std::size_t k = 0; k < i; ++k)
            depth = std::max(depth,
                             radius + scene.movable[k].radius - (states[i].position - states[k].position).norm());
    }
    return depth;
}

template <typename Measure>
double largest(const Run& run, std::size_t from, const Measure& measure) {
    double result = 0.0;
    for (std::size_t n = from; n <= last(run); ++n) result = std::max(result, measure(run.states[n]));
    return result;
}

double fastest(const std::vector<State>& states) {
    double result = 0.0;
    for (const State& s : states) result = std::max(result, s.velocity.norm());
    return result;
}

double sideways(const std::vector<State>& states, const std::vector<State>& from) {
    double result = 0.0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Vector3 moved = states[i].position - from[i].position;
        result = std::max(result, std::hypot(moved.x(), moved.z()));
    }
    return result;
}

double rest_height(const Scene& scene, std::size_t cube) {
    return (static_cast<double>(cube) + 0.5) * scene.movable[cube].size.y();
}

std::string outcome(const Scene& scene, const Run& run) {
    for (std::size_t n = 0; n <= last(run); ++n) {
        const std::vector<State>& states = run.states[n];
        for (std::size_t i = 0; i < states.size(); ++i) {
            const double half = 0.5 * scene.movable[i].size.y();
            const double lowest = std::min(scene.movable[i].start.position.y(), rest_height(scene, i)) - half;
            const double time = static_cast<double>(n) * step_length;
            if (!states[i].position.allFinite()) return fmt::format("not finite at {:.1f} s", time);
            if (states[i].position.y() < lowest) return fmt::format("falls at {:.1f} s", time);
            if (sideways(states, run.states[0]) > half) return fmt::format("leans at {:.1f} s", time);
        }
    }
    return "stands";
}

double percent(double part, double whole) {
    return 100.0 * part / whole;
}

double link_error(const Scene& scene, const Run& run, const std::vector<State>& states) {
    double error = 0.0;
    for (const Link& link : scene.links) {
        const Vector3 a = end_a(link, states);
        if (run.joint == Joint::distance) {
            error = std::max(error, std::abs((end_b(link, states) - a).norm() - link.length) / link.length);
            continue;
        }
        const State& from = scene.movable[static_cast<std::size_t>(link.b)].start;
        const State& s = states[static_cast<std::size_t>(link.b)];
        const Vector3 arm = from.orientation.conjugate() * (end_a(link, starts(scene)) - from.position);
        error = std::max(error, (s.position + s.orientation * arm - a).norm() / link.length);
    }
    return error;
}

}  // namespace

Values standing(const Scene& scene, const Run& run) {
    const std::string end = outcome(scene, run);
    const bool stands = end == "stands";
    const std::size_t settled = last(run) - (last(run) > 10 * second ? last(run) - 10 * second : 0);
    const auto depth = [&](const std::vector<State>& states) { return 1e3 * depth_of_cubes(scene, states); };
    const auto drift = [&](const std::vector<State>& states) {
        return 1e3 * sideways(states, run.states[settled]);
    };
    Values values{{"outcome", stands ? 1.0 : 0.0, end}};
    if (settled < last(run))
        values.push_back({"sideways after 10 s, mm", stands ? largest(run, settled, drift) : unknown, {}});
    values.push_back({"largest penetration, mm", stands ? largest(run, 0, depth) : unknown, {}});
    values.push_back({"in the last second, mm", stands ? largest(run, last(run) - second, depth) : unknown, {}});
    values.push_back({"largest speed in the last second, m/s",
                      finite(run) ? largest(run, last(run) - second, fastest) : unknown,
                      {}});
    return values;
}

Values parting(const Scene& scene, const Run& run) {
    const bool known = finite(run);
    double upward = 0.0, rise = 0.0, above = 0.0;
    for (std::size_t n = 1; n <= last(run); ++n) {
        for (std::size_t i = 0; i < scene.movable.size(); ++i) {
            const State& s = run.states[n][i];
            upward = std::max(upward, s.velocity.y());
            rise = std::max(rise, s.position.y() - run.states[n - 1][i].position.y());
            above = std::max(above, s.position.y() - rest_height(scene, i));
        }
    }
    const auto depth = [&](const std::vector<State>& states) { return 1e3 * depth_of_cubes(scene, states); };
    const bool thrown = above > 0.5 * scene.movable[0].size.y();
    const std::string end = thrown ? "thrown up" : outcome(scene, run);
    return {{"outcome", end == "stands" ? 1.0 : 0.0, end},
            {"largest upward speed, m/s", known ? upward : unknown, {}},
            {"largest rise in a step, m", known ? rise : unknown, {}},
            {"highest above its place at rest, m", known ? above : unknown, {}},
            {"penetration in the last second, mm",
             end == "stands" ? largest(run, last(run) - second, depth) : unknown,
             {}}};
}

Values chain(const Scene& scene, const Run& run) {
    const double begin = potential(scene, run.states[0]);
    double swing = 0.0, reach = 0.0;
    for (std::size_t i = 0; i < scene.links.size(); ++i) {
        reach += scene.links[i].length;
        swing += scene.movable[i].mass * scene.gravity.norm() * reach;
    }
    swing += begin;
    const bool known = finite(run);
    double error = 0.0, gain = 0.0, loss = unknown;
    for (std::size_t n = 0; known && n <= last(run); ++n) {
        error = std::max(error, link_error(scene, run, run.states[n]));
        if (n == last(run)) break;
        const double gained = energy(scene, run, n) - begin;
        gain = std::max(gain, gained);
        loss = -gained;
    }
    return {{"joint", 0.0, run.joint == Joint::distance ? "distance" : "ball joint, rigid arm"},
            {"largest link error, %", known ? 100.0 * error : unknown, known ? "" : "not finite"},
            {"largest gain of energy, %", known ? percent(gain, swing) : unknown, {}},
            {"loss at the end, %", percent(loss, swing), {}}};
}

Values wave(const Scene& scene, const Run& run) {
    double squares = 0.0, most = 0.0, swing = 0.0;
    const double gravity = scene.gravity.norm();
    for (const Link& link : scene.links) {
        const auto place = static_cast<std::size_t>(link.b);
        const auto angle = [&](const State& s) {
            return std::atan2(s.position.z() - link.point_a.z(), link.point_a.y() - s.position.y());
        };
        const double amplitude = angle(scene.movable[place].start);
        const Body& ball = scene.movable[place];
        swing += ball.mass * gravity * (link.length + ball.radius) * (1.0 - std::cos(amplitude));
        const std::vector<double> exact = exact_angles(ball, link, gravity, amplitude, run.joint, last(run));
        for (std::size_t n = 1; n <= last(run); ++n) {
            const double error = angle(run.states[n][place]) - exact[n];
            squares += error * error;
            most = std::max(most, std::abs(error));
        }
    }
    const double samples = static_cast<double>(scene.links.size() * last(run));
    const double begin = potential(scene, run.states[0]);
    const double degrees = 180.0 / std::numbers::pi;
    return {{"joint", 0.0, run.joint == Joint::distance ? "distance" : "ball joint, rigid arm"},
            {"angle error, rms, degrees", degrees * std::sqrt(squares / samples), {}},
            {"largest, degrees", degrees * most, {}},
            {"loss of energy, %", percent(begin - energy(scene, run, last(run) - 1), swing), {}}};
}

Values turning(const Scene& scene, const Run& run) {
    const Body& body = scene.movable[0];
    const Vector3 momentum = angular_momentum(body, body.start);
    const double begin = kinetic(scene, starts(scene));
    double energy_error = 0.0, momentum_error = 0.0;
    for (const std::vector<State>& states : run.states) {
        energy_error = std::max(energy_error, std::abs(kinetic(scene, states) - begin));
        momentum_error = std::max(momentum_error, (angular_momentum(body, states[0]) - momentum).norm());
    }
    const auto attitude_error = [&](double time) {
        const auto step = static_cast<std::size_t>(std::lround(time / step_length));
        return run.states[step][0].orientation.angularDistance(exact_attitude(body, time)) * 180.0 /
               std::numbers::pi;
    };
    return {{"largest energy error, %", percent(energy_error, begin), {}},
            {"largest error of angular momentum, %", percent(momentum_error, momentum.norm()), {}},
            {"attitude error after 1 s, degrees", attitude_error(1.0), {}},
            {"after 10 s, degrees", attitude_error(10.0), {}}};
}

Values through(const Scene& scene, const Run& run) {
    const std::vector<State>& states = run.states.back();
    const auto beyond =
        std::count_if(states.begin(), states.end(), [](const State& s) { return s.position.x() > 0.0; });
    return Values{
        Value{"through", static_cast<double>(beyond), fmt::format("{} of {}", beyond, scene.movable.size())}};
}

Values heap(const Scene& scene, const Run& run) {
    const bool known = finite(run);
    const std::size_t settled = last(run) - second;
    const auto depth = [&](const std::vector<State>& states) { return 1e3 * depth_of_spheres(scene, states); };
    const auto moving = [&](const std::vector<State>& states) { return kinetic(scene, states); };
    return {{"kinetic energy in the last second, J", known ? largest(run, settled, moving) : unknown, {}},
            {"largest speed, m/s", known ? largest(run, settled, fastest) : unknown, {}},
            {"largest penetration, mm", known ? largest(run, 0, depth) : unknown, {}},
            {"in the last second, mm", known ? largest(run, settled, depth) : unknown, {}}};
}

}  // namespace pushfactor::tests::peers
