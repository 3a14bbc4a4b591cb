#include "tests/peers/problems/problem_report.h"

#include "demos/base/platform/plain_name.h"
#include "demos/figures/plot.h"
#include "demos/reports/study.h"
#include "tests/peers/problems/profiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace pushfactor::tests::problems {

namespace {

using demos::SectionContent, demos::Section, demos::TextTable, demos::reports::StudyRun;

// Methods and problems in the order in which they first come.
template <typename Name>
std::vector<std::string> names_in(const std::vector<ProblemPoint>& points, const Name& name) {
    std::vector<std::string> names;
    for (const ProblemPoint& point : points) {
        if (std::find(names.begin(), names.end(), std::invoke(name, point)) == names.end())
            names.push_back(std::invoke(name, point));
    }
    return names;
}

std::string text_of_time(double seconds) {
    return std::isfinite(seconds) ? fmt::format("{:.3g} ms", 1e3 * seconds) : "never";
}

// "pgs 2.7 ms, nncg never"
std::string times_to(double error, const std::vector<ProblemPoint>& points, const std::string& problem) {
    std::string text;
    for (const std::string& method : names_in(points, &ProblemPoint::method)) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", method,
                            text_of_time(time_to(error, points, problem, method)));
    }
    return text;
}

Eigen::Index contacts_of(const ContactProblem& problem) {
    return std::visit([](const auto& one) { return one.contacts(); }, problem);
}

std::string title_of(const ContactProblem& problem) {
    return std::visit([](const auto& one) { return one.title; }, problem);
}

// Sizes, and what is special about W.
std::string text_of(const ContactProblem& problem) {
    std::string text = fmt::format("{} contacts", contacts_of(problem));
    if (const auto* const local = std::get_if<LocalProblem>(&problem)) {
        const double asymmetry = local->asymmetry();
        return text + (asymmetry > 1e-12
                           ? fmt::format(", W alone, which differs from its transpose by {:.2g} of its "
                                         "largest number",
                                         asymmetry)
                           : ", W alone");
    }
    return text + fmt::format(", {} unknowns of bodies", std::get<GlobalProblem>(problem).mass.rows());
}

// A block per method: ratio, share.
std::string profile_data(const std::vector<Profile>& profiles, double last) {
    std::string text;
    for (const Profile& profile : profiles) {
        text += "# " + profile.name + "\n";
        for (const auto& [ratio, share] : profile.steps) text += fmt::format("{},{}\n", ratio, share);
        text += fmt::format("{},{}\n\n\n", last, profile.steps.back().second);
    }
    return text;
}

// A plot of error against CPU time. `points` are those on this problem; `note` is that of solve_problem().
Section section_of(const ContactProblem& problem, const std::vector<ProblemPoint>& points, const std::string& note,
                   const StudyRun& run) {
    const std::string title = title_of(problem);
    const std::string name = demos::plain_name("problem_" + title, '_');
    Section section{.name = name, .heading = title, .content = {}};
    section.content.caption = fmt::format(
        "{}. From zero impulses, one thread; points are labelled with their iterations. The error is that of "
        "Siconos, |r - P_K(r - (u + mu |u_T| n))| / max(|q|, |r|, |u|), which mixes impulses and velocities; "
        "problems.csv also has errors in m/s. Time to 1e-4: {}; to 1e-8: {}.{}",
        text_of(problem), times_to(1e-4, points, title), times_to(1e-8, points, title),
        note.empty() ? "" : " Not as rows over bodies: " + note + ".");
    demos::reports::error::draw_work_plot({.name = name,
                                           .error_axis = "error of Siconos (no unit)",
                                           .work_axis = "CPU time [s]",
                                           .lines = lines_of(points),
                                           .theory = {}},
                                          run, section.content);
    return section;
}

// Dolan-Moré profiles of all methods over all problems.
Section profile_section(double error, const std::vector<ProblemPoint>& points, const StudyRun& run) {
    const std::vector<std::string> problems = names_in(points, &ProblemPoint::problem);
    std::vector<SolverTimes> solvers;
    for (const std::string& method : names_in(points, &ProblemPoint::method)) {
        SolverTimes& solver = solvers.emplace_back(SolverTimes{.name = method, .times = {}});
        for (const std::string& problem : problems) solver.times.push_back(time_to(error, points, problem, method));
    }
    const std::vector<Profile> profiles = profiles_of(solvers);
    SectionContent plate;
    TextTable table{{"method", "solved", "fastest on", "within 2 times the fastest", "within 10 times"}};
    std::string names, colours, dashes;
    double last = 10.0;
    const std::vector<WorkLine> lines = lines_of(points);
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        const auto percent = [&](double ratio) {
            return fmt::format("{:.0f} %", 100.0 * profiles[i].share_within(ratio));
        };
        const auto solved = std::count_if(solvers[i].times.begin(), solvers[i].times.end(),
                                          [](double time) { return std::isfinite(time); });
        table.push_back({profiles[i].name, fmt::format("{} of {}", solved, problems.size()), percent(1.0),
                         percent(2.0), percent(10.0)});
        const auto line = std::find_if(lines.begin(), lines.end(),
                                       [&](const WorkLine& one) { return one.name == profiles[i].name; });
        names += fmt::format("\"{}\" ", profiles[i].name);
        colours += line->colour + " ";
        dashes += std::to_string(line->dash) + " ";
        last = std::max(last, 1.5 * profiles[i].steps.back().first);
    }
    plate.table = table;
    plate.caption = fmt::format(
        "Performance profiles (Dolan and Moré) over {} problems: the share that a method solves to an error of "
        "{:.0e} (Siconos' measure) within so many times the CPU time of the fastest method on each. Higher and "
        "further left is better; where a line ends below 1, the rest was not solved. Methods without \"blocks\" "
        "work "
        "on bodies: they take global problems alone.",
        problems.size(), error);
    const std::string name = fmt::format("profile_{:.0e}", error);
    add_plot({.script = "profile",
              .data = name + ".dat",
              .name = name,
              .aspect = 1.6,
              .variables = {{"names", names},
                            {"colours", colours},
                            {"dashes", dashes},
                            {"last", last},
                            {"machine", run.machine()}}},
             profile_data(profiles, last), run.folder(), plate);
    return {name, fmt::format("All problems to an error of {:.0e}", error), std::move(plate)};
}

}  // namespace

void report_problems(const std::vector<ContactProblem>& problems, bool quick, OtherSolver other,
                     const std::filesystem::path& folder) {
    const demos::reports::Study study{
        .name = "problems", .title = "contact problems", .parts = {}, .make = nullptr};
    StudyRun run(study, {.folder = folder, .quick = quick});
    run.write("about.json", demos::reports::about_json());
    run.begin(problems.size());
    std::vector<ProblemPoint> all;
    for (const ContactProblem& problem : problems) {
        std::string note;
        std::vector<ProblemPoint> points = solve_problem(problem, quick, run.check(), note);
        const std::vector<ProblemPoint> others = other(local_form(problem), quick);
        points.insert(points.end(), others.begin(), others.end());
        all.insert(all.end(), points.begin(), points.end());
        run.write("problems.csv", table_of(all));
        run.sections.push_back(section_of(problem, points, note, run));
        run.count_run();
    }
    for (const double error : {1e-4, 1e-8}) run.sections.push_back(profile_section(error, all, run));
    run.write_page(fmt::format(
        "How wrong solvers are on contact problems of FCLib after how much CPU time; lower left is better. Times "
        "were measured on this machine: {}. The numbers are in problems.csv, the machine in about.json.{}",
        run.machine(), quick ? " This is the quick report: few iterations." : ""));
}

}  // namespace pushfactor::tests::problems
