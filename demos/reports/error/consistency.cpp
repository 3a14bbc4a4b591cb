#include "demos/reports/error/consistency.h"

#include "demos/runs/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pushfactor::demos::reports::error {

namespace {

using Bodies = std::vector<engine::Body>;

double length_of(const SceneDescription& scene) {
    for (const BodyDescription& body : scene.bodies) {
        if (!body.mass) continue;
        if (const auto* box = std::get_if<BoxShape>(&body.shape)) return box->size.minCoeff();
        if (const auto* sphere = std::get_if<SphereShape>(&body.shape)) return 2.0 * sphere->radius;
    }
    return 1.0;
}

Choices choices_at(const ConsistencyCase& which, const Rational& dt) {
    OptionTexts options{{"dt", to_text(dt)}};
    options.insert(options.end(), which.options.begin(), which.options.end());
    return run_of(which.scene, options);
}

// The scene as it is when its bodies are in this state. What is remembered of contacts is lost, in all runs alike.
SceneDescription restarted(SceneDescription scene, const Bodies& bodies) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!scene.bodies[i].mass) continue;
        scene.bodies[i].position = bodies[i].position;
        scene.bodies[i].orientation = bodies[i].orientation;
        scene.bodies[i].linear_momentum = bodies[i].linear_momentum;
        scene.bodies[i].angular_momentum = bodies[i].angular_momentum;
    }
    return scene;
}

void run_for(Simulation& run, const Rational& time, const std::function<void()>& check) {
    const Rational steps = time / run.settings().dt;
    for (long i = 0; i < steps.numerator / steps.denominator; ++i) {
        check();
        run.advance();
    }
}

Bodies after_window(const ConsistencyPlan& plan, const ConsistencyCase& which, const Bodies& start,
                    const Rational& dt, const std::function<void()>& check) {
    Choices choices = choices_at(which, dt);
    choices.description = restarted(choices.description, start);
    Simulation run(choices);
    run_for(run, plan.window, check);
    return run.scene().world.bodies;
}

// The states of one run of the smallest step at the starts of the windows.
std::vector<Bodies> starts_of(const ConsistencyPlan& plan, const ConsistencyCase& which,
                              const std::function<void()>& check) {
    const Choices choices = choices_at(which, plan.smallest);
    Simulation run(choices);
    std::vector<Bodies> states;
    Rational time{0, 1};
    for (const Rational& start : plan.starts) {
        const std::int64_t common = start.denominator * time.denominator;
        run_for(run, make_rational(start.numerator * time.denominator - time.numerator * start.denominator, common),
                check);
        time = start;
        states.push_back(run.scene().world.bodies);
    }
    return states;
}

}  // namespace

ConsistencyPlan consistency_plan(bool quick) {
    // Where nothing touches, half a kick back is right from any state and gives the second order. A chain needs the
    // iterations: what sweeps leave of its forces is another error, which does not shrink with the step. The
    // heavy-on-light scene begins at rest and is left out: there is no motion to compare.
    ConsistencyPlan plan{
        .cases = {{"stack", {}, "vermilion"},
                  {"intersecting-stack", {}, "orange"},
                  {"funnel", {}, "blue"},
                  {"pendulum-grid", {}, "green"},
                  {"pendulum-wave", {{"start-kick", "on"}}, "violet"},
                  {"chain", {{"start-kick", "on"}, {"iterations", "5000"}}, "grey"}},
        .steps = {{1, 60}, {1, 120}, {1, 240}, {1, 480}, {1, 960}},
        .smallest = {1, 7680},
        .starts = {{1, 10}, {1, 2}, {1, 1}, {3, 2}, {2, 1}, {5, 2}, {3, 1}, {4, 1}},
        .window = {1, 5},
    };
    if (quick) {
        plan.steps.resize(3);
        plan.smallest = {1, 960};
        plan.starts = {{1, 10}, {1, 2}};
    }
    return plan;
}

std::vector<ConsistencyPoint> check_consistency(const ConsistencyPlan& plan, const ConsistencyCase& which,
                                                const std::function<void()>& check) {
    const std::vector<Bodies> starts = starts_of(plan, which, check);
    std::vector<Bodies> ends;
    for (const Bodies& start : starts) ends.push_back(after_window(plan, which, start, plan.smallest, check));

    std::string differences;
    for (const auto& [name, value] : which.options)
        differences += (differences.empty() ? "" : " ") + name + "=" + value;
    std::vector<ConsistencyPoint> points;
    for (const Rational& dt : plan.steps) {
        double squares = 0.0, count = 0.0;
        for (std::size_t k = 0; k < starts.size(); ++k) {
            const Bodies bodies = after_window(plan, which, starts[k], dt, check);
            for (std::size_t i = 0; i < bodies.size(); ++i) {
                if (bodies[i].is_static()) continue;
                squares += (bodies[i].position - ends[k][i].position).squaredNorm();
                count += 1.0;
            }
        }
        ConsistencyPoint point{.scene = which.scene,
                               .differences = differences,
                               .dt = dt.value(),
                               .window = plan.window.value(),
                               .windows = static_cast<int>(starts.size()),
                               .error = std::sqrt(squares / count),
                               .size = length_of(choices_at(which, dt).description)};
        if (!points.empty() && point.error > 0.0) point.order = std::log2(points.back().error / point.error);
        points.push_back(point);
    }
    return points;
}

std::string csv_text(const std::vector<ConsistencyPoint>& points) {
    std::string text = "scene,differs_from_preset,dt_s,window_s,windows,error_rms_m,size_m,observed_order\n";
    for (const ConsistencyPoint& point : points) {
        text += fmt::format("{},{},{},{},{},{},{},{}\n", point.scene, point.differences, point.dt, point.window,
                            point.windows, point.error, point.size,
                            point.order ? fmt::format("{}", *point.order) : std::string());
    }
    return text;
}

}  // namespace pushfactor::demos::reports::error
