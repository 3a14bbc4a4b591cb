// The sections of the error report about contact problems of FCLib.
#pragma once

#include "demos/reports/error/contact_problems/problem_points.h"

#include <filesystem>
#include <optional>

namespace pushfactor::demos::reports::error {

struct ProblemSection {
    WorkPlot plot;
    std::string heading, caption;
};

class ProblemSections {
  public:
    // `beside` is a CSV file of other solvers with the columns of problems.csv. Throws UsageError if it is not.
    explicit ProblemSections(const std::optional<std::filesystem::path>& beside);

    // Describes what solve_problem() returned.
    ProblemSection add(const ContactProblem& problem, std::vector<ProblemPoint> own, const std::string& note,
                       const std::string& machine);

    // Dolan-Moré profiles of all methods over the problems so far.
    SectionContent profile(double error, const std::filesystem::path& folder, const std::string& machine) const;

    const std::vector<ProblemPoint>& points() const { return points_; }  // ours

  private:
    std::vector<ProblemPoint> all() const;

    std::vector<ProblemPoint> points_, others_;
};

}  // namespace pushfactor::demos::reports::error
