#include "demos/reports/error/contact_problems/problem_sections.h"

#include "demos/figures/plot.h"
#include "demos/reports/error/contact_problems/profiles.h"
#include "demos/text/csv.h"
#include "demos/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>

namespace pushfactor::demos::reports::error {

namespace {

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

std::vector<ProblemPoint> read_points(const std::filesystem::path& file) {
    std::vector<ProblemPoint> points;
    for (const auto& cells : read_csv("--beside", file, table_of(std::vector<ProblemPoint>{}).columns)) {
        const auto number = [&](std::size_t column) { return parse_number(cells[column]).value_or(0.0); };
        points.push_back({.problem = cells[0],
                          .method = cells[1],
                          .iterations = static_cast<int>(number(2)),
                          .errors = {.siconos = number(3),
                                     .natural_map = number(4),
                                     .penetration_rate = number(5),
                                     .cone_violation = number(7),
                                     .wrong_friction = number(6),
                                     .dissipation = number(8)},
                          .multiply_adds = number(9),
                          .cpu = number(10)});
    }
    return points;
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

}  // namespace

ProblemSections::ProblemSections(const std::optional<std::filesystem::path>& beside) {
    if (beside) others_ = read_points(*beside);
}

ProblemSection ProblemSections::add(const ContactProblem& problem, std::vector<ProblemPoint> own,
                                    const std::string& note, const std::string& machine) {
    points_.insert(points_.end(), own.begin(), own.end());
    for (const ProblemPoint& point : others_) {
        if (point.problem == title_of(problem)) own.push_back(point);
    }
    std::string name = "problem_";
    for (const char c : title_of(problem)) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    const std::string title = title_of(problem);
    return {
        .plot = {.name = name,
                 .error_axis = "error of Siconos (no unit)",
                 .work_axis = "CPU time [s]",
                 .machine = machine,
                 .lines = lines_of(own),
                 .theory = {}},
        .heading = title,
        .caption = fmt::format(
            "{}. From zero impulses, one thread; points are labelled with their iterations. The error is that of "
            "Siconos, |r - P_K(r - (u + mu |u_T| n))| / max(|q|, |r|, |u|), which mixes impulses and velocities; "
            "problems.csv also has errors in m/s. Time to 1e-4: {}; to 1e-8: {}.{}",
            text_of(problem), times_to(1e-4, own, title), times_to(1e-8, own, title),
            note.empty() ? "" : " Not as rows over bodies: " + note + ".")};
}

std::vector<ProblemPoint> ProblemSections::all() const {
    std::vector<ProblemPoint> points = points_;
    points.insert(points.end(), others_.begin(), others_.end());
    return points;
}

SectionContent ProblemSections::profile(double error, const std::filesystem::path& folder,
                                        const std::string& machine) const {
    const std::vector<ProblemPoint> points = all();
    const std::vector<std::string> problems = names_in(points_, &ProblemPoint::problem);
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
        "{:.0e} "
        "(Siconos' measure) within so many times the CPU time of the fastest method on each. Higher and further "
        "left "
        "is better; where a line ends below 1, the rest was not solved. Methods without \"blocks\" work on bodies: "
        "they "
        "take global problems alone.",
        problems.size(), error);
    const std::string name = fmt::format("profile_{:.0e}", error);
    add_plot(
        {.script = "profile",
         .data = name + ".dat",
         .name = name,
         .aspect = 1.6,
         .variables =
             {{"names", names}, {"colours", colours}, {"dashes", dashes}, {"last", last}, {"machine", machine}}},
        profile_data(profiles, last), folder, plate);
    return plate;
}

}  // namespace pushfactor::demos::reports::error
