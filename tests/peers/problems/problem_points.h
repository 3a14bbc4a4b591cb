// Solvers on the contact problems of others: how wrong they are after how much work.
#pragma once

#include "demos/pages/table.h"
#include "demos/reports/error/error.h"
#include "tests/peers/problems/contact_errors.h"
#include "tests/peers/problems/rows_of_contacts.h"

#include <functional>
#include <string>
#include <vector>

namespace pushfactor::tests::problems {

using demos::Table;
using demos::reports::error::WorkLine;

struct ProblemPoint {
    std::string problem, method;
    int iterations = 0;  // at most, or of sweeps
    ContactErrors errors;
    double multiply_adds = 0.0;
    double cpu = 0.0;  // s, median of some solves from zero
};

// Global problems as rows over bodies by the engine's solvers, local ones, and those that are not of rigid bodies,
// in blocks of W by sweeps. `check` is called before each solve; its exceptions end all. `note` receives what could
// not be done as rows, and why.
std::vector<ProblemPoint> solve_problem(const ContactProblem& problem, bool quick,
                                        const std::function<void()>& check, std::string& note);

// Impulses with the smallest error that our solvers find [N s]: the exact one, or else sweeps.
engine::VectorX best_impulses(const FrozenProblem& rows, const LocalProblem& problem);

Table table_of(const std::vector<ProblemPoint>& points);  // problems.csv

// Siconos' error against CPU time.
std::vector<WorkLine> lines_of(const std::vector<ProblemPoint>& points);

// CPU time until Siconos' error was at most `error` [s]; infinite if it was not reached.
double time_to(double error, const std::vector<ProblemPoint>& points, const std::string& problem,
               const std::string& method);

}  // namespace pushfactor::tests::problems
