#include "tests/peers/problems/problem_points.h"

#include "demos/base/platform/processors.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/median.h"
#include "engine/solvers/solver.h"
#include "tests/peers/problems/block_solvers.h"
#include "tests/peers/problems/rows_of_contacts.h"

#include <algorithm>
#include <limits>

namespace pushfactor::tests::problems {

namespace {

using demos::thread_cpu_us, demos::median, demos::UsageError;
using engine::VectorX;

constexpr double rounding = 1e-14;   // no solver needs more
constexpr double longest = 2.0;      // s, of a solve; more iterations are left out
constexpr double until_sure = 0.05;  // s, over all solves of a point
constexpr int most_repeats = 5;

// Empty for a solver of ours.
std::string colour_of_siconos(const std::string& method) {
    for (const auto& [name, colour] : {std::pair{"Siconos NSGS", "vermilion"},
                                       {"Siconos projection", "orange"},
                                       {"Siconos NSN_AC", "violet"},
                                       {"Siconos ADMM", "green"}}) {
        if (method.starts_with(name)) return colour;
    }
    return "";
}

std::vector<int> iterations(bool quick) {
    std::vector<int> numbers{1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};
    if (!quick) numbers.insert(numbers.end(), {2000, 5000, 10000, 20000, 50000});
    return numbers;
}

// What a solve gives and costs.
struct Solved {
    VectorX impulses;
    double multiply_adds = 0.0;
    double cpu = 0.0;  // s
};

template <typename Solve>
Solved timed(const Solve& solve) {
    Solved solved;
    std::vector<double> times;
    double sum = 0.0;
    for (int i = 0; i < most_repeats && (i == 0 || sum < until_sure); ++i) {
        const double start = thread_cpu_us();
        solve(solved);
        times.push_back(1e-6 * (thread_cpu_us() - start));
        sum += times.back();
    }
    solved.cpu = median(times);
    return solved;
}

class Solving {
  public:
    Solving(const LocalProblem& local, bool quick, const std::function<void()>& check)
        : local_(local), quick_(quick), check_(check) {}

    // Goes through the numbers of iterations while they help and do not take too long.
    template <typename Solve>
    void sweep_through(const std::string& method, const Solve& solve) {
        for (const int count : iterations(quick_)) {
            if (add(method, count, [&](Solved& solved) { solve(count, solved); })) return;
        }
    }

    // Returns whether more iterations would be in vain.
    template <typename Solve>
    bool add(const std::string& method, int count, const Solve& solve) {
        check_();
        const Solved solved = timed(solve);
        points_.push_back({.problem = local_.title,
                           .method = method,
                           .iterations = count,
                           .errors = contact_errors(local_, solved.impulses),
                           .multiply_adds = solved.multiply_adds,
                           .cpu = solved.cpu});
        return solved.cpu > longest || points_.back().errors.siconos < rounding;
    }

    std::vector<ProblemPoint> points() { return std::move(points_); }

  private:
    const LocalProblem& local_;
    bool quick_;
    const std::function<void()>& check_;
    std::vector<ProblemPoint> points_;
};

void solve_rows(const FrozenProblem& problem, Solving& solving) {
    for (const std::string name : {"pgs", "nncg", "jacobi"}) {
        solving.sweep_through(name, [&](int count, Solved& solved) {
            engine::Columns lambda = problem.zero();
            const auto solver = engine::solvers::make_solver(name);
            // Tolerances of zero: always all iterations.
            solved.multiply_adds = solver->solve(problem.system(), {.iterations = count}, lambda).multiply_adds;
            solved.impulses = impulses_of(lambda);
        });
    }
    constexpr double tolerance = 1e-12;  // m/s
    constexpr int most_sweeps = 1000;    // where exact methods do not get there
    solving.add("direct", most_sweeps, [&](Solved& solved) {
        engine::Columns lambda = problem.zero();
        const auto solver = engine::solvers::make_solver("direct");
        solved.multiply_adds =
            solver
                ->solve(problem.system(),
                        {.iterations = most_sweeps, .tolerance_high = tolerance, .tolerance_low = tolerance},
                        lambda)
                .multiply_adds;
        solved.impulses = impulses_of(lambda);
    });
}

void solve_blocks(const LocalProblem& problem, Solving& solving) {
    const BlockProblem blocks(problem);
    for (const BlockSolver& solver : block_solvers()) {
        solving.sweep_through(std::string(solver.name) + ", blocks", [&](int count, Solved& solved) {
            solved.impulses = solver.solve(blocks, problem.free.size(), count);
            solved.multiply_adds = count * blocks.multiply_adds_of_a_sweep();
        });
    }
}

}  // namespace

std::vector<ProblemPoint> solve_problem(const ContactProblem& problem, bool quick,
                                        const std::function<void()>& check, std::string& note) {
    const LocalProblem local = local_form(problem);
    Solving solving(local, quick, check);
    if (const auto* const global = std::get_if<GlobalProblem>(&problem)) {
        try {
            solve_rows(rows_over_bodies(*global), solving);
        } catch (const UsageError& error) {
            note = error.what();
        }
    }
    solve_blocks(local, solving);
    return solving.points();
}

VectorX best_impulses(const FrozenProblem& rows, const LocalProblem& problem) {
    constexpr double enough = 1e-12;
    VectorX best = VectorX::Zero(problem.free.size());
    double least = contact_errors(problem, best).siconos;
    const auto consider = [&](const char* solver, const engine::solvers::Termination& termination) {
        if (least <= enough) return;
        engine::Columns lambda = engine::Columns::Zero(best.size(), 1);
        engine::solvers::make_solver(solver)->solve(rows.system(), termination, lambda);
        const double error = contact_errors(problem, impulses_of(lambda)).siconos;
        if (error < least) best = impulses_of(lambda), least = error;
    };
    consider("direct", {.iterations = 1000, .tolerance_high = enough, .tolerance_low = enough});
    for (const int sweeps : {1000, 10000, 100000}) consider("nncg", {.iterations = sweeps});
    return best;
}

Table table_of(const std::vector<ProblemPoint>& points) {
    Table table{{"problem", "method", "iterations", "siconos_error", "natural_map_m_per_s", "penetration_m_per_s",
                 "wrong_friction_m_per_s", "cone_violation_n_s", "dissipation_n_m", "work_multiply_adds", "cpu_s"}};
    for (const ProblemPoint& point : points) {
        const ContactErrors& errors = point.errors;
        table.rows.push_back({point.problem, point.method, point.iterations, errors.siconos, errors.natural_map,
                              errors.penetration_rate, errors.wrong_friction, errors.cone_violation,
                              errors.dissipation, point.multiply_adds, point.cpu});
    }
    return table;
}

std::vector<WorkLine> lines_of(const std::vector<ProblemPoint>& points) {
    std::vector<WorkLine> lines;
    for (const ProblemPoint& point : points) {
        if (lines.empty() || lines.back().name != point.method) {
            const bool blocks = point.method.ends_with("blocks");
            const std::string other = colour_of_siconos(point.method);
            lines.push_back(
                {.name = point.method,
                 .colour = other.empty() ? demos::reports::error::colour_of_solver(point.method) : other,
                 .dash = !other.empty() ? 3
                         : blocks       ? 2
                                        : 1,
                 .mark = !other.empty() ? 9
                         : blocks       ? 5
                                        : 7,
                 .points = {}});
        }
        lines.back().points.push_back(
            {.error = point.errors.siconos, .work = point.cpu, .label = std::to_string(point.iterations)});
    }
    return lines;
}

double time_to(double error, const std::vector<ProblemPoint>& points, const std::string& problem,
               const std::string& method) {
    double best = std::numeric_limits<double>::infinity();
    for (const ProblemPoint& point : points) {
        if (point.problem == problem && point.method == method && point.errors.siconos <= error) {
            best = std::min(best, point.cpu);
        }
    }
    return best;
}

}  // namespace pushfactor::tests::problems
