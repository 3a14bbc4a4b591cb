// Errors of methods against their work: error.csv (whole runs), frozen.csv (systems of one moment), consistency.csv
// (scenes against themselves at smaller steps), and their plots.
#include "demos/base/platform/output_file.h"
#include "demos/base/platform/plain_name.h"
#include "demos/base/text/suggest.h"
#include "demos/reports/error/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

namespace pushfactor::demos::reports {

namespace {

using namespace error;

constexpr const char* frozen_part = "frozen";
constexpr const char* consistency_part = "consistency";
constexpr std::array answered{1e-2, 1e-4, 1e-6, 1e-8};  // errors of the first table

std::vector<Experiment> experiments_of(const StudyRequest& request) {
    return request.wanted(error_experiments(request.quick), &Experiment::name);
}

std::vector<FrozenMoment> moments_of(const StudyRequest& request) {
    return request.wants(frozen_part) ? hard_moments(request.quick) : std::vector<FrozenMoment>();
}

// Throws UsageError for points of other engines that cannot be read or that are on no scene of the request.
std::vector<ErrorPoint> others_of(const StudyRequest& request) {
    if (!request.beside) return {};
    std::vector<ErrorPoint> others = read_error_points(*request.beside);
    const auto has_others = [&](const Experiment& sweep) {
        return std::ranges::find(others, sweep.scene, &ErrorPoint::scene) != others.end();
    };
    if (std::ranges::none_of(experiments_of(request), has_others)) {
        throw UsageError("--beside {}: must have points on scenes of the report", request.beside->string());
    }
    return others;
}

Pieces error_pieces(const StudyRequest& request) {
    others_of(request);
    Pieces pieces;
    for (const Experiment& sweep : experiments_of(request)) {
        for (const Method& method : sweep.methods) {
            for (const std::string& value : method.values) pieces.push_back(piece_of(sweep, method, value));
        }
    }
    for (const FrozenMoment& moment : moments_of(request)) pieces.push_back(piece_of(moment, request.quick));
    if (request.wants(consistency_part)) add_consistency(request.quick, pieces);
    return pieces;
}

// Moves of all bodies per simulated second.
double moves_at(const Experiment& sweep, const Method& method, const std::string& value) {
    const Settings settings = run_at(sweep, method, value).settings;
    return method.moves * settings.substeps.value_or(1) / settings.dt.value();
}

// Over work, or over CPU time.
std::vector<WorkLine> lines_of(const Experiment& sweep, std::span<const ErrorPoint> points, bool over_time) {
    std::vector<WorkLine> lines;
    for (const Method& method : sweep.methods) {
        WorkLine& line = lines.emplace_back(WorkLine{method.name, method.colour, method.dash, method.mark});
        for (const ErrorPoint& point : points) {
            if (point.method != method.name) continue;
            const double work = over_time      ? point.cpu.median
                                : sweep.solves ? point.multiply_adds
                                               : moves_at(sweep, method, point.value);
            line.points.push_back({point.error(), work, point.value, point.failed});
        }
    }
    return lines;
}

// Error ~ work^-order through the second point of a method: the first step is often too large for its order.
WorkLine power_line(double order, const WorkPoint& through) {
    WorkLine theory{.name = fmt::format("order {:g}", order)};
    for (double exponent = -6.0; exponent <= 6.0; exponent += 0.05) {
        const double factor = std::pow(10.0, exponent);
        theory.points.push_back({through.error * std::pow(factor, -order), through.work * factor});
    }
    return theory;
}

// Error ~ contraction^sweeps, work ~ sweeps, through a point after some sweeps.
WorkLine contraction_line(double contraction, const WorkPoint& through) {
    const double sweeps = std::stod(through.label);
    WorkLine theory{.name = "cos^2(pi/2n) a sweep"};
    for (double share = 0.02; share <= 20.0; share *= 1.02) {
        theory.points.push_back(
            {through.error * std::pow(contraction, sweeps * (share - 1.0)), through.work * share});
    }
    return theory;
}

std::vector<WorkLine> theory_of(const Experiment& sweep, const std::vector<WorkLine>& lines) {
    std::vector<WorkLine> theory;
    std::set<double> orders;
    for (std::size_t i = 0; i < sweep.methods.size(); ++i) {
        const Method& method = sweep.methods[i];
        if (lines[i].points.size() < 2) continue;
        if (method.order > 0.0 && !lines[i].points[1].failed && orders.insert(method.order).second)
            theory.push_back(power_line(method.order, lines[i].points[1]));
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
        } else if (!best || point.error() < best->error()) {
            best = &point;
        }
    }
    std::string text;
    if (best) {
        text += fmt::format(" The smallest error, {:.2g}, is that of {} at {} {}.", best->error(), best->method,
                            best->knob, best->value);
    }
    if (!failures.empty()) text += fmt::format(" Hollow: {}.", fmt::join(failures, "; "));
    return text;
}

class ErrorReport {
  public:
    explicit ErrorReport(StudyRun& run) : run_(run), others_(others_of(run.request())) {}

    void make() {
        const auto& exported = run_.request().exported;
        run_.write("about.json", about_json());
        if (exported) make_folder(*exported);
        for (const Experiment& sweep : experiments_of(run_.request())) add_experiment(sweep);
        for (const FrozenMoment& moment : moments_of(run_.request())) add_moment(moment);
        if (exported) {
            for (const ContactMoment& moment : contact_moments(run_.quick()))
                export_problem(freeze(moment.name, moment.choices, run_.check()), moment.name);
        }
        if (run_.request().wants(consistency_part)) add_consistency(run_);
        put_answer_first();
        run_.write_page(
            fmt::format("True errors (against closed forms, exact motion, converged forces) against the work of a "
                        "method; lower left is better. Work is counted in multiply-adds of the solver and is the "
                        "same on every machine; CPU times were measured on this one: {}. The numbers are in "
                        "error.csv, frozen.csv and consistency.csv, the machine in about.json.{}",
                        run_.machine(), run_.quick() ? " This is the quick report: few values, short runs." : ""));
    }

  private:
    void add_experiment(const Experiment& sweep) {
        const std::size_t first = points_.size();
        for (const Method& method : sweep.methods) {
            for (const std::string& value : method.values)
                points_.push_back(point_in(run_.result(piece_of(sweep, method, value).key), method));
        }
        run_.write("error.csv", table_of(points_));
        const auto points = std::span<const ErrorPoint>(points_).subspan(first);
        SectionContent plate{.caption = sweep.caption + numbers_of(points)};
        WorkPlot plot{.name = plain_name("error_" + sweep.name, '_'),
                      .error_axis = sweep.error_axis,
                      .work_axis = sweep.solves ? "work of the solver [multiply-adds] a simulated second"
                                                : "moves of the bodies a simulated second",
                      .lines = lines_of(sweep, points, false)};
        plot.theory = theory_of(sweep, plot.lines);
        draw_work_plot(plot, run_, plate);
        plot.name = plain_name("error_cpu_" + sweep.name, '_');
        plot.work_axis = "CPU time [s] a simulated second";
        plot.lines = lines_of(sweep, points, true);
        plot.theory.clear();  // part of the CPU time does not depend on the knob
        draw_work_plot(plot, run_, plate);
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
        SectionContent plate{.pictures = answer_pictures_, .table = answers_};
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
        const std::vector<ErrorPoint> others = about(others_, sweep.scene, points_.back().errors.front().name);
        if (others.empty()) return;
        const TextTable faster = who_is_faster(plot.lines, others);
        plot.name = plain_name("beside_" + sweep.name, '_');
        plot.lines = lines_beside(plot.lines, others);
        run_.sections.push_back(work_section(
            plot, sweep.title + ", beside other engines",
            "In colour our methods that no other of ours beats everywhere, in grey other engines (tests/compare "
            "error), on one machine in one run: CPU time of the steps, one thread. Where an engine has no bar, a "
            "link is a ball joint at the end of an arm that is fixed to the ball, and the exact motion is that of "
            "this.",
            run_, {.table = faster}));
    }

    void add_moment(const FrozenMoment& moment) {
        const Json result = run_.result(piece_of(moment, run_.quick()).key);
        const auto lines = result.at("lines").get<TextTable>();
        for (const auto& cells : lines) frozen_.rows.emplace_back(cells.begin(), cells.end());
        run_.write("frozen.csv", frozen_);
        const WorkPlot plot{.name = plain_name("frozen_" + moment.name, '_'),
                            .error_axis = "residual [m/s]",
                            .work_axis = "work of the solve [multiply-adds]",
                            .lines = error::lines_of(lines)};
        if (run_.request().exported) export_problem(freeze(moment, run_.check()), plot.name);
        const int columns = result.at("columns");
        run_.sections.push_back(work_section(
            plot, "Frozen: " + moment.name,
            fmt::format("The system of one moment, {} rows and {} column{}, solved from zero (cold) and from the "
                        "forces of the step before (warm); points are labelled with their iterations. Residual: "
                        "the largest velocity that a row still gets wrong.",
                        result.at("rows").get<int>(), columns, columns == 1 ? "" : "s"),
            run_, {.commands = {command_text("run", moment.scene, moment.options)}}));
    }

    void export_problem(const FrozenProblem& problem, const std::string& name) const {
        write_file(*run_.request().exported / (name + ".json"), problem.text());
    }

    StudyRun& run_;
    std::vector<ErrorPoint> others_;  // of other engines
    std::vector<ErrorPoint> points_;
    Table frozen_{frozen_columns};
    TextTable answers_{{"scene", "error", "1e-2", "1e-4", "1e-6", "1e-8"}};
    std::vector<std::string> answer_pictures_;
    std::map<std::string, int> wins_;  // by method
};

}  // namespace

Study error_study() {
    return {.name = "error",
            .title = "error against run time",
            .parts =
                [] {
                    std::vector<std::string> parts = names_of(error_experiments(true));
                    parts.insert(parts.end(), {frozen_part, consistency_part});
                    return parts;
                },
            .make = [](StudyRun& run) { ErrorReport(run).make(); },
            .pieces = error_pieces,
            .at_once = 1};  // because it measures times
}

}  // namespace pushfactor::demos::reports
