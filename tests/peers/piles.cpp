#include "tests/peers/piles.h"

#include "tests/peers/mechanics.h"
#include "tests/peers/overlap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pushfactor::tests::peers {

namespace {

constexpr std::size_t second = 60;  // steps
constexpr double at_rest = 1e-4;    // m/s
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::size_t last(const Run& run) {
    return run.states.size() - 1;
}

double in_seconds(std::size_t steps) {
    return static_cast<double>(steps) * step_length;
}

// Bodies that should come to rest: not balls where there are boxes, because these may roll away for ever.
std::vector<std::size_t> resting_bodies(const Scene& scene) {
    std::vector<std::size_t> boxes, all;
    for (std::size_t i = 0; i < scene.movable.size(); ++i) {
        if (scene.movable[i].shape == Shape::box) boxes.push_back(i);
        all.push_back(i);
    }
    return boxes.empty() ? all : boxes;
}

// Of the fastest of `bodies` in the step that ends in state n > 0: its velocity, or its displacement in that step
// where that is more, because engines push bodies apart by displacements that are in no velocity.
double top_speed(const Run& run, const std::vector<std::size_t>& bodies, std::size_t n) {
    double speed = 0.0;
    for (const std::size_t i : bodies) {
        const State& s = run.states[n][i];
        const double way = (s.position - run.states[n - 1][i].position).norm();
        speed = std::max({speed, s.velocity.norm(), way / step_length});
    }
    return speed;
}

double top_speed_at_end(const Scene& scene, const Run& run) {
    const std::vector<std::size_t> bodies = resting_bodies(scene);
    double speed = 0.0;
    for (std::size_t n = last(run) - second + 1; n <= last(run); ++n)
        speed = std::max(speed, top_speed(run, bodies, n));
    return speed;
}

// s; NaN where it never rests.
double rests_from(const Scene& scene, const Run& run) {
    const std::vector<std::size_t> bodies = resting_bodies(scene);
    std::size_t n = last(run);
    while (n > 0 && top_speed(run, bodies, n) < at_rest) --n;
    return n < last(run) ? in_seconds(n) : unknown;
}

// Over the start, J. Velocities may lie up to a step before the positions, more or less in an engine that divides
// its steps: the smaller kinetic energy of this state and the next, so that no lag looks like a gain.
double energy_gain(const Scene& scene, const Run& run) {
    const double begin = potential(scene, run.states[0]) + kinetic(scene, run.states[0]);
    double gain = 0.0, before = kinetic(scene, run.states[0]);
    for (std::size_t n = 0; n < last(run); ++n) {
        const double after = kinetic(scene, run.states[n + 1]);
        gain = std::max(gain, potential(scene, run.states[n]) + std::min(before, after) - begin);
        before = after;
    }
    return gain;
}

// Of a body from its place at the start, up to state `end`, m.
double moved(const Run& run, std::size_t end) {
    double most = 0.0;
    for (std::size_t n = 1; n <= end; ++n) {
        for (std::size_t i = 0; i < run.states[n].size(); ++i)
            most = std::max(most, (run.states[n][i].position - run.states[0][i].position).norm());
    }
    return most;
}

// The median over the steps that end in states after `from`, and the deepest in any of them.
Values overlaps(const Scene& scene, const Run& run, std::size_t from) {
    if (!finite(run)) return {{typical_overlap, unknown, {}}, {"deepest, mm", unknown, {}}};
    std::vector<double> rms;
    double deepest = 0.0;
    for (std::size_t n = from + 1; n <= last(run); ++n) {
        const Overlap found = overlap(scene, run.states[n]);
        rms.push_back(found.rms);
        deepest = std::max(deepest, found.deepest);
    }
    std::sort(rms.begin(), rms.end());
    return {{typical_overlap, 1e3 * rms[rms.size() / 2], {}}, {"deepest, mm", 1e3 * deepest, {}}};
}

Values appended(Values values, const Values& more) {
    values.insert(values.end(), more.begin(), more.end());
    return values;
}

// NaN where the states are NaN.
template <typename Measure>
Value value(const Run& run, const std::string& name, const Measure& measure) {
    return {name, finite(run) ? measure() : unknown, {}};
}

}  // namespace

Values falling(const Scene& scene, const Run& run) {
    return appended(overlaps(scene, run, 0),
                    {value(run, "gain of energy, J", [&] { return energy_gain(scene, run); })});
}

Values settled(const Scene& scene, const Run& run) {
    return appended(overlaps(scene, run, last(run) - second),
                    {value(run, "speed in the last second, m/s", [&] { return top_speed_at_end(scene, run); }),
                     value(run, "below 0.1 mm/s from, s", [&] { return rests_from(scene, run); })});
}

Values structure(const Scene& scene, const Run& run) {
    const std::size_t soon = std::min(2 * second, last(run));
    const std::string end = fmt::format("in {:.0f} s, mm", in_seconds(last(run)));
    return appended({value(run, "moved in 2 s, mm", [&] { return 1e3 * moved(run, soon); }),
                     value(run, end, [&] { return 1e3 * moved(run, last(run)); }),
                     value(run, "gain of energy, J", [&] { return energy_gain(scene, run); }),
                     value(run, "speed in the last second, m/s", [&] { return top_speed_at_end(scene, run); }),
                     value(run, "below 0.1 mm/s from, s", [&] { return rests_from(scene, run); })},
                    overlaps(scene, run, 0));
}

}  // namespace pushfactor::tests::peers
