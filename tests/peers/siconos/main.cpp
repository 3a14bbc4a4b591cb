// Siconos on contact problems of FCLib: siconos FILE.hdf5... prints the lines of problems.csv, one per solver and
// tolerance, with the error that was reached.
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
#include <memory>
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

void run(const Method& method, const LocalProblem& local) {
    for (int digits = 1; digits <= 12; ++digits) {
        Problem problem(local);
        const Options options(method);
        options.get->dparam[SICONOS_DPARAM_TOL] = std::pow(10.0, -digits);
        VectorX impulses = VectorX::Zero(local.free.size()), velocities = VectorX::Zero(local.free.size());
        const double start = cpu_time();
        fc3d_driver(problem.get(), impulses.data(), velocities.data(), options.get);
        const double cpu = cpu_time() - start;
        const ContactErrors errors =
            impulses.allFinite() ? contact_errors(local, impulses) : ContactErrors{.siconos = 1e9};
        fmt::print("\"{}\",{},{},{},{},{},{},{},{},{},{}\n", local.title, method.name,
                   options.get->iparam[SICONOS_IPARAM_ITER_DONE], errors.siconos, errors.natural_map,
                   errors.penetration_rate, errors.wrong_friction, errors.cone_violation, errors.dissipation, 0.0,
                   cpu);
        std::fflush(stdout);
        const bool used_up = options.get->iparam[SICONOS_IPARAM_ITER_DONE] >= method.most_iterations;
        if (cpu > longest || used_up) break;
    }
}

}  // namespace

int main(int argc, char** argv) {
    fmt::print(
        "problem,method,iterations,siconos_error,natural_map_m_per_s,penetration_m_per_s,wrong_friction_m_per_s,"
        "cone_violation_n_s,dissipation_n_m,work_multiply_adds,cpu_s\n");
    numerics_set_verbose(0);
    for (int i = 1; i < argc; ++i) {
        const ContactProblem problem = read_fclib(argv[i]);
        const auto* const global = std::get_if<GlobalProblem>(&problem);
        const LocalProblem local = global ? local_form(*global) : std::get<LocalProblem>(problem);
        for (const Method& method : methods) run(method, local);
    }
}
