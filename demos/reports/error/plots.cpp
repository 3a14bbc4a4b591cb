#include "demos/reports/error/plots.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace pushfactor::demos::reports::error {

namespace {

using MakeWork = std::function<double(const ErrorPoint&)>;

double plotted_error(const ErrorPoint& point) {
    return point.errors.front().value;
}

// "frozen_stack_of_5_landing"
std::string file_name(const std::string& prefix, const std::string& text) {
    std::string name = prefix;
    for (const char c : text) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (plain || name.back() != '_') name += plain ? c : '_';
    }
    return name;
}

std::vector<WorkLine> lines_of(const Experiment& sweep, const std::vector<ErrorPoint>& points,
                               const MakeWork& work) {
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

// Error ~ contraction^sweeps, work ~ sweeps, through a point that is some sweeps along.
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
            // Late enough for the slowest part of the error alone to be left, early enough for rounding.
            const auto& points = lines[i].points;
            const auto through = std::find_if(points.rbegin(), points.rend(),
                                              [](const WorkPoint& point) { return point.error > 1e-8; });
            if (through != points.rend()) theory.push_back(contraction_line(sweep.contraction, *through));
        }
    }
    return theory;
}

std::string numbers_of(const std::vector<ErrorPoint>& points) {
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
        text += fmt::format(" The least error, {:.2g}, is that of {} at {} {}.", plotted_error(*best), best->method,
                            best->knob, best->value);
    }
    if (!failures.empty()) text += fmt::format(" Hollow: {}.", fmt::join(failures, "; "));
    return text;
}

}  // namespace

std::vector<Section> error_sections(const Experiment& sweep, const std::vector<ErrorPoint>& points,
                                    const std::string& machine, const std::filesystem::path& folder) {
    const MakeWork work = [&sweep](const ErrorPoint& point) {
        return sweep.solves ? point.multiply_adds : point.moves;
    };
    const MakeWork cpu = [](const ErrorPoint& point) { return point.cpu.median; };
    std::vector<Section> sections;
    for (const bool seconds : {false, true}) {
        WorkPlot plot{.name = file_name(seconds ? "error_cpu_" : "error_", sweep.scene),
                      .error_axis = sweep.error_axis,
                      .work_axis = seconds        ? "CPU time [s] a simulated second"
                                   : sweep.solves ? "work of the solver [multiply-adds] a simulated second"
                                                  : "moves of the bodies a simulated second",
                      .machine = machine,
                      .lines = lines_of(sweep, points, seconds ? cpu : work),
                      .theory = {}};
        // The CPU time has a part that no knob changes, so there is nothing to know of it beforehand.
        if (!seconds) plot.theory = theory_of(sweep, plot.lines);
        Section section{plot.name, sweep.title + (seconds ? ", CPU time" : ""), {}};
        section.plate.caption = sweep.caption + numbers_of(points);
        draw_work_plot(plot, folder, section.plate);
        sections.push_back(std::move(section));
    }
    return sections;
}

Section frozen_section(const FrozenMoment& moment, const FrozenProblem& problem,
                       const std::vector<FrozenPoint>& points, const std::string& machine,
                       const std::filesystem::path& folder) {
    const WorkPlot plot{.name = file_name("frozen_", moment.name),
                        .error_axis = "residual [m/s]",
                        .work_axis = "work of the solve [multiply-adds]",
                        .machine = machine,
                        .lines = lines_of(points),
                        .theory = {}};
    Section section{plot.name, "Frozen: " + moment.name, {}};
    section.plate.caption = fmt::format(
        "The system of one moment, {} rows and {} column{}, solved from zero (cold) and from the forces of the "
        "step "
        "before (warm); points are labelled with their iterations. Residual: the largest velocity that a row still "
        "gets wrong.",
        problem.system().row_count(), problem.system().column_count(),
        problem.system().column_count() == 1 ? "" : "s");
    section.plate.commands = {command_text("run", moment.scene, moment.options)};
    draw_work_plot(plot, folder, section.plate);
    return section;
}

Section consistency_section(const ConsistencyPlan& plan, const std::vector<ConsistencyPoint>& points,
                            const std::string& machine, const std::filesystem::path& folder) {
    WorkPlot plot{.name = "consistency",
                  .error_axis = "difference of the centres after a window, RMS [m]",
                  .work_axis = "steps a second",
                  .machine = machine,
                  .lines = {},
                  .theory = {},
                  .front = false};
    std::string orders;
    for (const ConsistencyCase& which : plan.cases) {
        WorkLine line{.name = which.scene, .colour = which.colour, .points = {}};
        double last = std::numeric_limits<double>::quiet_NaN();
        for (const ConsistencyPoint& point : points) {
            if (point.scene != which.scene) continue;
            line.points.push_back({point.error, 1.0 / point.dt, fmt::format("1/{:.0f} s", 1.0 / point.dt)});
            last = point.order.value_or(last);
        }
        orders += fmt::format("{}{} {:.1f}", orders.empty() ? "" : ", ", which.scene, last);
        plot.lines.push_back(std::move(line));
    }
    Section section{plot.name, "Consistency: each scene against itself at smaller steps", {}};
    section.plate.caption = fmt::format(
        "{} windows of {} s, begun anew from states of a run at {} s steps, which is also what they are compared "
        "with. Order of the last halving: {}.",
        plan.starts.size(), to_text(plan.window), to_text(plan.smallest), orders);
    draw_work_plot(plot, folder, section.plate);
    return section;
}

}  // namespace pushfactor::demos::reports::error
