// Siconos on contact problems of FCLib.
//   siconos FILE.hdf5...          prints the lines of problems.csv, one per solver and tolerance, with the error
//   reached siconos agree FILE.hdf5...    compares its best solution with the one in the file: velocities, and W
//   times the
//                                 difference of the impulses, which is zero where they differ in its null space
//                                 alone
#include "demos/reports/error/contact_problems/contact_errors.h"
#include "demos/reports/error/contact_problems/fclib_file.h"

#include <fmt/format.h>
#include <siconos/numerics/FrictionContactProblem.h>
#include <siconos/numerics/Friction_cst.h>
#include <siconos/numerics/NonSmoothDrivers.h>
#include <siconos/numerics/NumericsMatrix.h>
#include <siconos/numerics/NumericsVerbose.h>
#include <siconos/numerics/SolverOptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <string_view>
#include <vector>

namespace {

using namespace pushfactor::demos::reports::error;
using pushfactor::engine::VectorX;

constexpr double longest = 5.0;  // s, of a solve; smaller tolerances are left out

struct Method {
    const char* name;
    int solver;
    int of_one_contact;  // the solver within NSGS; 0: its default
    int most_iterations;
};

// As their authors recommend them, with the iterations to get there.
constexpr std::array methods{
    Method{"Siconos NSGS", SICONOS_FRICTION_3D_NSGS, 0, 200000},
    Method{"Siconos projection on the cone", SICONOS_FRICTION_3D_NSGS,
           SICONOS_FRICTION_3D_ONECONTACT_ProjectionOnConeWithLocalIteration, 200000},
    Method{"Siconos NSN_AC", SICONOS_FRICTION_3D_NSN_AC, 0, 1000},
    Method{"Siconos ADMM", SICONOS_FRICTION_3D_ADMM, 0, 100000},
};

double cpu_time() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The problem in the structures of Siconos, which frees them.
class Problem {
  public:
    explicit Problem(const LocalProblem& local) : free_(local.free), mu_(local.mu) {
        NumericsMatrix* const matrix =
            NM_create(NM_SPARSE, static_cast<int>(local.matrix.rows()), static_cast<int>(local.matrix.cols()));
        NM_triplet_alloc(matrix, static_cast<CS_INT>(local.matrix.nonZeros()));
        for (Eigen::Index column = 0; column < local.matrix.outerSize(); ++column) {
            for (SparseMatrix::InnerIterator entry(local.matrix, column); entry; ++entry) {
                NM_entry(matrix, static_cast<int>(entry.row()), static_cast<int>(entry.col()), entry.value());
            }
        }
        problem_.dimension = 3;
        problem_.numberOfContacts = static_cast<int>(local.contacts());
        problem_.M = matrix;
        problem_.q = free_.data();
        problem_.mu = mu_.data();
    }
    ~Problem() {
        NM_clear(problem_.M);
        std::free(problem_.M);
    }
    Problem(const Problem&) = delete;
    Problem& operator=(const Problem&) = delete;

    FrictionContactProblem* get() { return &problem_; }

  private:
    VectorX free_, mu_;
    FrictionContactProblem problem_{};
};

struct Options {
    SolverOptions* get;
    explicit Options(const Method& method) : get(solver_options_create(method.solver)) {
        if (method.of_one_contact != 0) solver_options_update_internal(get, 0, method.of_one_contact);
        get->iparam[SICONOS_IPARAM_MAX_ITER] = method.most_iterations;
    }
    ~Options() { solver_options_delete(get); }
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;
};

struct Answer {
    VectorX impulses;
    int iterations = 0;
    double cpu = 0.0;  // s
};

Answer solve(const Method& method, double tolerance, const LocalProblem& local) {
    Problem problem(local);
    const Options options(method);
    options.get->dparam[SICONOS_DPARAM_TOL] = tolerance;
    VectorX impulses = VectorX::Zero(local.free.size()), velocities = VectorX::Zero(local.free.size());
    const double start = cpu_time();
    fc3d_driver(problem.get(), impulses.data(), velocities.data(), options.get);
    return {impulses, options.get->iparam[SICONOS_IPARAM_ITER_DONE], cpu_time() - start};
}

// The most accurate of its solvers.
VectorX best_of(const LocalProblem& local) {
    VectorX best = VectorX::Zero(local.free.size());
    double least = contact_errors(local, best).siconos;
    for (const Method& method : methods) {
        if (least < 1e-13) break;
        const Answer answer = solve(method, 1e-14, local);
        if (!answer.impulses.allFinite()) continue;
        const double error = contact_errors(local, answer.impulses).siconos;
        if (error < least) best = answer.impulses, least = error;
    }
    return best;
}

void agree(const char* file, const LocalProblem& local) {
    const std::optional<VectorX> stored = read_solution(file);
    if (!stored) {
        fmt::print("{},no solution,,,,\n", local.title);
        return;
    }
    const VectorX theirs = best_of(local), difference = *stored - theirs;
    fmt::print("{},{:.1e},{:.1e},{:.1e},{:.1e}\n", local.title, contact_errors(local, *stored).siconos,
               contact_errors(local, theirs).siconos, (local.matrix * difference).lpNorm<Eigen::Infinity>(),
               difference.norm() / std::max(theirs.norm(), 1e-300));
    std::fflush(stdout);
}

void run(const Method& method, const LocalProblem& local) {
    for (int digits = 1; digits <= 12; ++digits) {
        const auto [impulses, iterations, cpu] = solve(method, std::pow(10.0, -digits), local);
        const ContactErrors errors =
            impulses.allFinite() ? contact_errors(local, impulses) : ContactErrors{.siconos = 1e9};
        fmt::print("\"{}\",{},{},{},{},{},{},{},{},{},{}\n", local.title, method.name, iterations, errors.siconos,
                   errors.natural_map, errors.penetration_rate, errors.wrong_friction, errors.cone_violation,
                   errors.dissipation, 0.0, cpu);
        std::fflush(stdout);
        const bool used_up = iterations >= method.most_iterations;
        if (cpu > longest || used_up) break;
    }
}

}  // namespace

int main(int argc, char** argv) {
    const bool agrees = argc > 1 && std::string_view(argv[1]) == "agree";
    fmt::print("{}", agrees
                         ? "problem,our_error,their_error,velocity_difference_m_per_s,impulse_difference\n"
                         : "problem,method,iterations,siconos_error,natural_map_m_per_s,penetration_m_per_s,"
                           "wrong_friction_m_per_s,cone_violation_n_s,dissipation_n_m,work_multiply_adds,cpu_s\n");
    numerics_set_verbose(0);
    for (int i = agrees ? 2 : 1; i < argc; ++i) {
        const ContactProblem problem = read_fclib(argv[i]);
        const auto* const global = std::get_if<GlobalProblem>(&problem);
        const LocalProblem local = global ? local_form(*global) : std::get<LocalProblem>(problem);
        if (agrees)
            agree(argv[i], local);
        else
            for (const Method& method : methods) run(method, local);
    }
}
