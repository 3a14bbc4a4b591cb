#include "demos/reports/error_report.h"

#include "demos/pages/about.h"
#include "demos/platform/output_file.h"
#include "demos/platform/progress.h"
#include "demos/reports/error/consistency.h"
#include "demos/reports/error/frozen_moments.h"
#include "demos/reports/error/plots.h"
#include "demos/reports/parts.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports {

namespace {

using namespace error;

constexpr int repeats = 5;  // of each run for the clock
constexpr const char* frozen_part = "frozen";
constexpr const char* consistency_part = "consistency";

// One report in the making.
class ErrorReport {
  public:
    explicit ErrorReport(const ErrorRequest& request)
        : request_(request),
          about_(about_this()),
          experiments_(wanted_experiments()),
          moments_(wants(frozen_part) ? hard_moments(request.quick) : std::vector<FrozenMoment>{}),
          plan_(consistency_plan(request.quick)),
          bar_("report error", total()) {
        make_folder(request_.folder);
        if (request_.problems) make_folder(request_.folder / "problems");
        write_file(request_.folder / "about.json", json_text(about_));
    }

    void make() {
        for (const Experiment& sweep : experiments_) add_experiment(sweep);
        for (const FrozenMoment& moment : moments_) add_moment(moment);
        if (wants(consistency_part)) add_consistency();
    }

  private:
    bool wants(const std::string& part) const { return is_wanted(part, request_.parts); }

    std::vector<Experiment> wanted_experiments() const {
        std::vector<Experiment> sweeps = error_experiments(request_.quick);
        std::erase_if(sweeps, [this](const Experiment& sweep) { return !wants(sweep.scene); });
        return sweeps;
    }

    long total() const {
        std::size_t count = moments_.size() + (wants(consistency_part) ? plan_.cases.size() : 0);
        for (const Experiment& sweep : experiments_) {
            for (const Method& method : sweep.methods) count += method.values.size();
        }
        return static_cast<long>(count);
    }

    void check() const {
        stop_if_interrupted(
            fmt::format("{} of {} plots are in {}", sections_.size(),
                        2 * experiments_.size() + moments_.size() + (wants(consistency_part) ? 1 : 0),
                        request_.folder.string()));
    }

    void one_more() { bar_.show(++done_); }

    void write_table(const char* name, const std::string& text) const {
        write_file(request_.folder / name, fmt::format("# {}\n{}", line_of(about_), text));
    }

    void add_experiment(const Experiment& sweep) {
        std::vector<ErrorPoint> points;
        for (const Method& method : sweep.methods) {
            for (const std::string& value : method.values) {
                points.push_back(run_point(sweep, method, value, repeats, [this] { check(); }));
                one_more();
            }
        }
        points_.insert(points_.end(), points.begin(), points.end());
        write_table("error.csv", csv_text(points_));
        for (Section& section : error_sections(sweep, points, line_of(about_), request_.folder)) {
            sections_.push_back(std::move(section));
        }
        write_page();
    }

    void add_moment(const FrozenMoment& moment) {
        const FrozenProblem problem = freeze(moment, [this] { check(); });
        const std::vector<FrozenPoint> points = solve_frozen(problem, request_.quick);
        frozen_.insert(frozen_.end(), points.begin(), points.end());
        write_table("frozen.csv", csv_text(frozen_));
        Section section = frozen_section(moment, problem, points, line_of(about_), request_.folder);
        if (request_.problems) {
            const std::string file = "problems/" + section.name + ".json";
            write_file(request_.folder / file, problem.text());
            section.plate.files.push_back(file);
        }
        sections_.push_back(std::move(section));
        write_page();
        one_more();
    }

    void add_consistency() {
        std::vector<ConsistencyPoint> points;
        for (const ConsistencyCase& which : plan_.cases) {
            const auto own = check_consistency(plan_, which, [this] { check(); });
            points.insert(points.end(), own.begin(), own.end());
            one_more();
        }
        write_table("consistency.csv", csv_text(points));
        sections_.push_back(consistency_section(plan_, points, line_of(about_), request_.folder));
        write_page();
    }

    void write_page() const {
        const std::string opening = fmt::format(
            "Errors against something true (closed forms, the exact motion, converged forces) against the work "
            "that "
            "they took; lower left is better. Work is counted in multiply-adds of the solver and is the same on "
            "every machine; CPU times were measured on this one: {}. The numbers are in error.csv, frozen.csv and "
            "consistency.csv, the machine in about.json.{}",
            line_of(about_), request_.quick ? " This is the quick report: few values, short runs." : "");
        write_file(request_.folder / "index.html",
                   page_text("Pushfactor: error against run time", opening, sections_));
    }

    ErrorRequest request_;
    About about_;
    std::vector<Experiment> experiments_;
    std::vector<FrozenMoment> moments_;
    ConsistencyPlan plan_;
    ProgressBar bar_;
    long done_ = 0;
    std::vector<ErrorPoint> points_;
    std::vector<FrozenPoint> frozen_;
    std::vector<Section> sections_;
};

}  // namespace

std::vector<std::string> error_parts() {
    std::vector<std::string> parts;
    for (const Experiment& sweep : error_experiments(true)) parts.push_back(sweep.scene);
    parts.emplace_back(frozen_part);
    parts.emplace_back(consistency_part);
    return parts;
}

void report_error(const ErrorRequest& request) {
    ErrorReport(request).make();
}

}  // namespace pushfactor::demos::reports
