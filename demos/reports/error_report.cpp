// Errors of methods against their work: error.csv (whole runs), frozen.csv (systems of one moment), consistency.csv
// (scenes against themselves at smaller steps), and their plots.
#include "demos/platform/output_file.h"
#include "demos/platform/plain_name.h"
#include "demos/reports/about.h"
#include "demos/reports/error/error_pieces.h"
#include "demos/reports/error/other_engines.h"
#include "demos/reports/error/work_plot.h"
#include "demos/reports/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>

namespace pushfactor::demos::reports {

namespace {

using namespace error;

constexpr std::array answered{1e-2, 1e-4, 1e-6, 1e-8};  // errors of the first table

using MakeWork = std::function<double(const ErrorPoint&)>;

double plotted_error(const ErrorPoint& point) {
    return point.errors.front().value;
}

std::vector<WorkLine> lines_of(const Experiment& sweep, std::span<const ErrorPoint> points, const MakeWork& work) {
    std::vector<WorkLine> lines;
    for (const Method& method : sweep.methods) {
        WorkLine line{method.name, method.colour, method.dash, method.mark, {}};
        for (const ErrorPoint& point : points) {
            if (point.method != method.name) continue;
            line.points.push_back({plotted_error(point), work(point), point.value, point.failed});
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

// Error ~ work^-order through the second point of a method: the first step is often too large for its order.
TheoryLine power_line(double order, const WorkPoint& through) {
    TheoryLine theory{.label = fmt::format("order {:g}", order), .points = {}};
    for (double exponent = -6.0; exponent <= 6.0; exponent += 0.05) {
        const double factor = std::pow(10.0, exponent);
        theory.points.emplace_back(through.error * std::pow(factor, -order), through.work * factor);
    }
    return theory;
}

// Error ~ contraction^sweeps, work ~ sweeps, through a point after some sweeps.
TheoryLine contraction_line(double contraction, const WorkPoint& through) {
    const double sweeps = std::stod(through.label);
    TheoryLine theory{.label = "cos^2(pi/2n) a sweep", .points = {}};
    for (double share = 0.02; share <= 20.0; share *= 1.02) {
        theory.points.emplace_back(through.error * std::pow(contraction, sweeps * (share - 1.0)),
                                   through.work * share);
    }
    return theory;
}

std::vector<TheoryLine> theory_of(const Experiment& sweep, const std::vector<WorkLine>& lines) {
    std::vector<TheoryLine> theory;
    std::vector<double> orders;
    for (std::size_t i = 0; i < sweep.methods.size(); ++i) {
        const Method& method = sweep.methods[i];
        if (lines[i].points.size() < 2) continue;
        const bool known = std::find(orders.begin(), orders.end(), method.order) != orders.end();
        if (method.order > 0.0 && !known && !lines[i].points[1].failed) {
            theory.push_back(power_line(method.order, lines[i].points[1]));
            orders.push_back(method.order);
        }
        if (sweep.contraction > 0.0 && method.name == "pgs") {
            // Late enough for only the slowest mode of the error to be left, early enough to be above rounding.
            const auto& points = lines[i].points;
            const auto through = std::find_if(points.rbegin(), points.rend(),
                                              [](const WorkPoint& point) { return point.error > 1e-8; });
            if (through != points.rend()) theory.push_back(contraction_line(sweep.contraction, *through));
        }
    }
    return theory;
}

std::string numbers_of(std::span<const ErrorPoint> points) {
    const ErrorPoint* best = nullptr;
    std::vector<std::string> failures;
    for (const ErrorPoint& point : points) {
        if (point.failed) {
            failures.push_back(
                fmt::format("{} at {} {} ({})", point.method, point.knob, point.value, point.outcome));
        } else if (!best || plotted_error(point) < plotted_error(*best)) {
            best = &point;
        }
    }
    std::string text;
    if (best) {
        text += fmt::format(" The smallest error, {:.2g}, is that of {} at {} {}.", plotted_error(*best),
                            best->method, best->knob, best->value);
    }
    if (!failures.empty()) text += fmt::format(" Hollow: {}.", fmt::join(failures, "; "));
    return text;
}

class ErrorReport {
  public:
    explicit ErrorReport(StudyRun& run) : run_(run), plan_(error_plan(run.request())) {}

    void make() {
        run_.write("about.json", about_json(about_this()));
        if (run_.request().exported) make_folder(*run_.request().exported);
        for (const Experiment& sweep : plan_.experiments) add_experiment(sweep);
        for (const FrozenMoment& moment : plan_.moments) add_moment(moment);
        if (run_.request().exported) {
            for (const ContactMoment& moment : contact_moments(run_.quick())) {
                export_problem(freeze(moment.name, moment.choices, run_.check()), moment.name);
            }
        }
        if (!plan_.consistency.cases.empty()) add_consistency();
        put_answer_first();
        write_page();
    }

  private:
    void add_experiment(const Experiment& sweep) {
        const std::size_t first = points_.size();
        for (const Method& method : sweep.methods) {
            for (const std::string& value : method.values) {
                points_.push_back(point_in(run_.result(key_of(sweep, method, value))));
            }
        }
        run_.write("error.csv", table_of(points_));
        const auto points = std::span<const ErrorPoint>(points_).subspan(first);
        SectionContent plate;
        plate.caption = sweep.caption + numbers_of(points);
        WorkPlot plot;
        for (const bool seconds : {false, true}) {
            plot = {.name = plain_name((seconds ? "error_cpu_" : "error_") + sweep.name, '_'),
                    .error_axis = sweep.error_axis,
                    .work_axis = seconds        ? "CPU time [s] a simulated second"
                                 : sweep.solves ? "work of the solver [multiply-adds] a simulated second"
                                                : "moves of the bodies a simulated second",
                    .machine = run_.machine(),
                    .lines = lines_of(sweep, points,
                                      [&](const ErrorPoint& point) {
                                          if (seconds) return point.cpu.median;
                                          return sweep.solves ? point.multiply_adds : point.moves;
                                      }),
                    .theory = {}};
            // Part of the CPU time does not depend on the knob, so theory does not apply to it.
            if (!seconds) plot.theory = theory_of(sweep, plot.lines);
            draw_work_plot(plot, run_.folder(), plate);
        }
        add_answer(sweep, plot.lines, plate);
        run_.sections.push_back({plain_name("error_" + sweep.name, '_'), sweep.title, std::move(plate)});
        add_others(sweep, plot);
    }

    // Which method reaches an error in the least CPU time; `lines` are over that time.
    void add_answer(const Experiment& sweep, std::span<const WorkLine> lines, const SectionContent& drawn) {
        std::vector<std::string>& row = answers_.emplace_back();
        row = {sweep.title, sweep.error_axis};
        for (const double error : answered) {
            const auto [line, point] = cheapest(lines, error);
            row.push_back(point ? fmt::format("{} ({}), {:.2g} ms", line->name, point->label, 1e3 * point->work)
                                : "not reached");
            if (point) ++wins_[line->name];
        }
        // One figure: the first.
        if (answer_pictures_.empty() && drawn.pictures.size() == 2) answer_pictures_ = {drawn.pictures.back()};
    }

    void put_answer_first() {
        if (answers_.size() < 2) return;
        std::vector<std::pair<std::string, int>> wins(wins_.begin(), wins_.end());
        std::ranges::stable_sort(wins, [](const auto& a, const auto& b) { return a.second > b.second; });
        std::vector<std::string> counts;
        for (const auto& [name, count] : wins) counts.push_back(fmt::format("{} {}", name, count));
        SectionContent plate;
        plate.pictures = answer_pictures_;
        plate.table = answers_;
        plate.caption = fmt::format(
            "For each scene the method that reaches an error in the least CPU time of the steps per simulated "
            "second, and in brackets its iterations, tolerance or step. How often each is the fastest: {}. The "
            "figure is that of the first scene; both of its axes are logarithmic, as in all figures of this page.",
            fmt::join(counts, ", "));
        run_.sections.insert(run_.sections.begin(),
                             {"answer", "Which method reaches which error in which time", std::move(plate)});
    }

    // The same plot with other engines, if there are any.
    void add_others(const Experiment& sweep, WorkPlot plot) {
        const std::vector<ErrorPoint> others = about(plan_.others, sweep.scene, points_.back().errors.front().name);
        if (others.empty()) return;
        SectionContent plate;
        plate.table = who_is_faster(plot.lines, others);
        plot.name = plain_name("beside_" + sweep.name, '_');
        plot.lines = lines_beside(plot.lines, others);
        add(plot, sweep.title + ", beside other engines",
            "In colour our methods that no other of ours beats everywhere, in grey other engines (tests/compare "
            "error), on one machine in one run: CPU time of the steps, one thread. Where an engine has no bar, a "
            "link is a ball joint at the end of an arm that is fixed to the ball, and the exact motion is that of "
            "this.",
            plate);
    }

    void add_moment(const FrozenMoment& moment) {
        const auto [points, rows, columns] = frozen_in(run_.result(key_of(moment, run_.quick())));
        frozen_.insert(frozen_.end(), points.begin(), points.end());
        run_.write("frozen.csv", table_of(frozen_));
        const WorkPlot plot{.name = plain_name("frozen_" + moment.name, '_'),
                            .error_axis = "residual [m/s]",
                            .work_axis = "work of the solve [multiply-adds]",
                            .machine = run_.machine(),
                            .lines = error::lines_of(points),
                            .theory = {}};
        SectionContent plate;
        plate.commands = {command_text("run", moment.scene, moment.options)};
        if (run_.request().exported) export_problem(freeze(moment, run_.check()), plot.name);
        add(plot, "Frozen: " + moment.name,
            fmt::format("The system of one moment, {} rows and {} column{}, solved from zero (cold) and from the "
                        "forces of the step before (warm); points are labelled with their iterations. Residual: "
                        "the largest velocity that a row still gets wrong.",
                        rows, columns, columns == 1 ? "" : "s"),
            plate);
    }

    void export_problem(const FrozenProblem& problem, const std::string& name) const {
        write_file(*run_.request().exported / (name + ".json"), problem.text());
    }

    void add_consistency() {
        const ConsistencyPlan& plan = plan_.consistency;
        Table table{{"scene", "differs_from_preset", "dt_s", "window_s", "windows", "error_rms_m", "size_m",
                     "observed_order"}};
        WorkPlot plot{.name = "consistency",
                      .error_axis = "difference of the centres after a window, RMS [m]",
                      .work_axis = "steps per second",
                      .machine = run_.machine(),
                      .lines = {},
                      .theory = {},
                      .front = false};
        std::vector<std::string> orders;
        for (const ConsistencyCase& which : plan.cases) {
            WorkLine line{.name = which.scene, .colour = which.colour, .points = {}};
            std::vector<std::string> differences;
            for (const auto& [name, value] : which.options) differences.push_back(name + "=" + value);
            double last = std::numeric_limits<double>::quiet_NaN();
            for (const auto& [dt, error, size, order] : consistency_in(run_.result(key_of(plan, which)))) {
                table.rows.push_back({which.scene, fmt::format("{}", fmt::join(differences, " ")), dt,
                                      plan.window.value(), plan.starts.size(), error, size, order});
                line.points.push_back({error, 1.0 / dt, fmt::format("1/{:.0f} s", 1.0 / dt)});
                last = order.value_or(last);
            }
            orders.push_back(fmt::format("{} {:.1f}", which.scene, last));
            plot.lines.push_back(std::move(line));
        }
        run_.write("consistency.csv", table);
        add(plot, "Consistency: each scene against itself at smaller steps",
            fmt::format("{} windows of {} s, restarted from states of a run with {} s steps, with which they are "
                        "compared. Order of the last halving: {}.",
                        plan.starts.size(), to_text(plan.window), to_text(plan.smallest), fmt::join(orders, ", ")));
    }

    void add(const WorkPlot& plot, const std::string& heading, const std::string& caption,
             SectionContent plate = {}) {
        plate.caption = caption;
        draw_work_plot(plot, run_.folder(), plate);
        run_.sections.push_back({plot.name, heading, std::move(plate)});
    }

    void write_page() const {
        run_.write_page(
            fmt::format("True errors (against closed forms, exact motion, converged forces) against the work of a "
                        "method; lower left is better. Work is counted in multiply-adds of the solver and is the "
                        "same on every machine; CPU times were measured on this one: {}. The numbers are in "
                        "error.csv, frozen.csv and consistency.csv, the machine in about.json.{}",
                        run_.machine(), run_.quick() ? " This is the quick report: few values, short runs." : ""));
    }

    StudyRun& run_;
    ErrorPlan plan_;
    std::vector<ErrorPoint> points_;
    std::vector<FrozenPoint> frozen_;
    TextTable answers_{{"scene", "error", "1e-2", "1e-4", "1e-6", "1e-8"}};
    std::vector<std::string> answer_pictures_;
    std::map<std::string, int> wins_;  // by method
};

}  // namespace

Study error_study() {
    std::vector<std::string> parts;
    for (const Experiment& sweep : error_experiments(true)) parts.push_back(sweep.name);
    parts.insert(parts.end(), {frozen_part, consistency_part});
    return {.name = "error",
            .title = "error against run time",
            .parts = parts,
            .make = [](StudyRun& run) { ErrorReport(run).make(); },
            .pieces = error_pieces,
            .at_once = 1};  // because it measures times
}

}  // namespace pushfactor::demos::reports
