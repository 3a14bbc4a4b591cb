#include "tests/peers/problems/siconos.h"

#if PUSHFACTOR_SICONOS

#include <siconos/numerics/FrictionContactProblem.h>
#include <siconos/numerics/Friction_cst.h>
#include <siconos/numerics/NonSmoothDrivers.h>
#include <siconos/numerics/NumericsMatrix.h>
#include <siconos/numerics/NumericsVerbose.h>
#include <siconos/numerics/SolverOptions.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>

namespace pushfactor::tests::problems {

namespace {

using engine::VectorX;

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

}  // namespace

bool has_siconos() {
    return true;
}

std::vector<ProblemPoint> siconos_points(const LocalProblem& problem, bool quick) {
    numerics_set_verbose(0);
    std::vector<ProblemPoint> points;
    for (const Method& method : methods) {
        for (int digits = 1; digits <= (quick ? 4 : 12); ++digits) {
            const auto [impulses, iterations, cpu] = solve(method, std::pow(10.0, -digits), problem);
            points.push_back(
                {.problem = problem.title,
                 .method = method.name,
                 .iterations = iterations,
                 .errors = impulses.allFinite() ? contact_errors(problem, impulses) : ContactErrors{.siconos = 1e9},
                 .cpu = cpu});
            const bool used_up = iterations >= method.most_iterations;
            if (cpu > longest || used_up) break;
        }
    }
    return points;
}

VectorX best_of_siconos(const LocalProblem& problem) {
    numerics_set_verbose(0);
    VectorX best = VectorX::Zero(problem.free.size());
    double least = contact_errors(problem, best).siconos;
    for (const Method& method : methods) {
        if (least < 1e-13) break;
        const Answer answer = solve(method, 1e-14, problem);
        if (!answer.impulses.allFinite()) continue;
        const double error = contact_errors(problem, answer.impulses).siconos;
        if (error < least) best = answer.impulses, least = error;
    }
    return best;
}

}  // namespace pushfactor::tests::problems

#else

namespace pushfactor::tests::problems {

bool has_siconos() {
    return false;
}

std::vector<ProblemPoint> siconos_points(const LocalProblem&, bool) {
    return {};
}

engine::VectorX best_of_siconos(const LocalProblem& problem) {
    return engine::VectorX::Zero(problem.free.size());
}

}  // namespace pushfactor::tests::problems

#endif
