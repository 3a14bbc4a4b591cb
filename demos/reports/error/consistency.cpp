#include "demos/reports/error/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

namespace pushfactor::demos::reports::error {

namespace {

using Bodies = std::vector<engine::Body>;

struct Compared {
    std::string scene;
    std::string differs;  // options
    std::string colour;   // in the plot
};

// Without contacts the start kick is right from any state and gives second order. A chain needs the iterations: the
// sweeps' error in its forces does not shrink with the step. The heavy-on-light scene is left out: it begins at
// rest, so there is no motion to compare.
const std::vector<Compared> compared{{"stack", "", "vermilion"},
                                     {"intersecting-stack", "", "orange"},
                                     {"funnel", "", "blue"},
                                     {"pendulum-grid", "", "green"},
                                     {"pendulum-wave", "start-kick=on", "violet"},
                                     {"chain", "start-kick=on iterations=5000", "grey"}};

struct Plan {
    explicit Plan(bool quick) {
        if (!quick) return;
        steps.resize(3);
        smallest = {1, 960};
        starts.resize(2);
    }

    std::vector<Rational> steps{{1, 60}, {1, 120}, {1, 240}, {1, 480}, {1, 960}};  // s, each half of the one before
    Rational smallest{1, 7680};                                                    // s
    // s, of the windows, whole numbers of the smallest step, and the length of each.
    std::vector<Rational> starts{{1, 10}, {1, 2}, {1, 1}, {3, 2}, {2, 1}, {5, 2}, {3, 1}, {4, 1}};
    Rational window{1, 5};
};

std::string joined(const std::vector<Rational>& values) {
    std::vector<std::string> texts;
    for (const Rational& value : values) texts.push_back(to_text(value));
    return fmt::format("{}", fmt::join(texts, ","));
}

// Of the first movable body.
double length_of(const SceneDescription& scene) {
    const BodyDescription& body =
        *std::ranges::find_if(scene.bodies, &std::optional<double>::has_value, &BodyDescription::mass);
    const auto* box = std::get_if<BoxShape>(&body.shape);
    return box ? box->size.minCoeff() : 2.0 * bounding_radius(body);
}

Choices choices_at(const Compared& which, const Rational& dt) {
    return run_of(which.scene, options(which.differs + " dt=" + to_text(dt)));
}

// Up to a time since the start [s].
void run_until(Simulation& run, const Rational& time, const StopCheck& check) {
    const Rational steps = time / run.settings().dt;
    play_steps(run, steps.numerator / steps.denominator, check);
}

Bodies after_window(const Plan& plan, const Compared& which, const Bodies& start, const Rational& dt,
                    const StopCheck& check) {
    Choices choices = choices_at(which, dt);
    // Cached contact forces are lost, in all runs alike.
    auto& bodies = choices.description.bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) take_state(start[i], bodies[i]);
    Simulation run(choices);
    run_until(run, plan.window, check);
    return run.scene().world.bodies;
}

// Per step: its length [s], the error [m], the size of a movable body [m], and the order against twice the step.
Table errors_of(const Plan& plan, const Compared& which, const StopCheck& check) {
    Simulation fine(choices_at(which, plan.smallest));
    std::vector<Bodies> starts, ends;
    for (const Rational& start : plan.starts) {
        run_until(fine, start, check);
        starts.push_back(fine.scene().world.bodies);
        ends.push_back(after_window(plan, which, starts.back(), plan.smallest, check));
    }
    Table table;
    double last = 0.0;
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
        const double error = std::sqrt(squares / count);
        const bool has_order = !table.rows.empty() && error > 0.0;
        table.rows.push_back({dt.value(), error, length_of(choices_at(which, dt).description),
                              has_order ? Cell(std::log2(last / error)) : Cell()});
        last = error;
    }
    return table;
}

Piece piece_of(const Plan& plan, const Compared& which) {
    return {fmt::format("error: consistency of {}; steps {}, against {}; windows of {} s from {}",
                        run_key(which.scene, options(which.differs)), joined(plan.steps), to_text(plan.smallest),
                        to_text(plan.window), joined(plan.starts)),
            [plan, &which](const StopCheck& check) { return Json(exact_rows(errors_of(plan, which, check))); }};
}

}  // namespace

void add_consistency(bool quick, Pieces& pieces) {
    for (const Compared& which : compared) pieces.push_back(piece_of(Plan(quick), which));
}

void add_consistency(StudyRun& run) {
    const Plan plan(run.quick());
    Table table{
        {"scene", "differs_from_preset", "dt_s", "window_s", "windows", "error_rms_m", "size_m", "observed_order"}};
    WorkPlot plot{.name = "consistency",
                  .error_axis = "difference of the centres after a window, RMS [m]",
                  .work_axis = "steps per second",
                  .front = false};
    std::vector<std::string> orders;
    for (const Compared& which : compared) {
        WorkLine& line = plot.lines.emplace_back(WorkLine{.name = which.scene, .colour = which.colour});
        double last = std::numeric_limits<double>::quiet_NaN();
        const Json result = run.result(piece_of(plan, which).key);
        for (const std::vector<std::string> cells : result) {
            table.rows.push_back({which.scene, which.differs, cells.at(0), plan.window.value(), plan.starts.size(),
                                  cells.at(1), cells.at(2), cells.at(3)});
            const double steps = 1.0 / std::stod(cells[0]);
            line.points.push_back({std::stod(cells[1]), steps, fmt::format("1/{:.0f} s", steps)});
            if (!cells[3].empty()) last = std::stod(cells[3]);
        }
        orders.push_back(fmt::format("{} {:.1f}", which.scene, last));
    }
    run.write("consistency.csv", table);
    run.sections.push_back(work_section(
        plot, "Consistency: each scene against itself at smaller steps",
        fmt::format("{} windows of {} s, restarted from states of a run with {} s steps, with which they are "
                    "compared. Order of the last halving: {}.",
                    plan.starts.size(), to_text(plan.window), to_text(plan.smallest), fmt::join(orders, ", ")),
        run));
}

}  // namespace pushfactor::demos::reports::error
