// Contact problems in FCLib's terms: our rows say the same, files keep every bit, errors have their closed forms.
#include "demos/reports/error/contact_problems/block_solvers.h"
#include "demos/reports/error/contact_problems/contact_errors.h"
#include "demos/reports/error/contact_problems/contact_moments.h"
#include "demos/reports/error/contact_problems/fclib_file.h"
#include "demos/reports/error/contact_problems/profiles.h"
#include "demos/reports/error/contact_problems/rows_of_contacts.h"
#include "engine/solvers/solver.h"
#include "tests/catch.h"
#include "tests/demos/pages/check_page.h"
#include "tests/demos/program.h"
#include "tests/random.h"
#include "tests/skip.h"

#include <iostream>
#include <set>

using namespace pushfactor;
using namespace pushfactor::demos::reports::error;
using namespace pushfactor::tests;
using engine::VectorX;

namespace {

bool skips_without_fclib() {
    if (has_fclib()) return false;
    skip("FCLib is not installed (packages libfclib-dev and libhdf5-dev)");
    return true;
}

bool same(const SparseMatrix& a, const SparseMatrix& b) {
    return a.rows() == b.rows() && a.cols() == b.cols() && (a.toDense() - b.toDense()).isZero(0.0);
}

// A brick of 2 kg on a plane, at its corners or at one point; it moves with this velocity before the step.
GlobalProblem brick(const engine::Vector6& velocity, double mu) {
    const double mass = 2.0, inertia = 0.5;
    GlobalProblem problem{.title = "brick",
                          .mass = SparseMatrix(6, 6),
                          .axes = SparseMatrix(6, 3),
                          .force = VectorX(6),
                          .given = VectorX::Zero(3),
                          .mu = VectorX::Constant(1, mu)};
    for (int i = 0; i < 6; ++i) problem.mass.insert(i, i) = i < 3 ? mass : inertia;
    // Under its centre: the normal is y, the tangents are z and x.
    problem.axes.insert(1, 0) = 1.0;
    problem.axes.insert(2, 1) = 1.0;
    problem.axes.insert(0, 2) = 1.0;
    problem.force = problem.mass * velocity;
    return problem;
}

VectorX solved(const FrozenProblem& problem, const char* solver, int iterations) {
    engine::Columns lambda = problem.zero();
    engine::solvers::make_solver(solver)->solve(problem.system(), {.iterations = iterations}, lambda);
    return impulses_of(lambda);
}

}  // namespace

TEST_CASE("the errors of a brick have their closed forms") {
    // It falls at 1 m/s and slides at 3 m/s; mu is 0.5. The impulses are 2 N s up and 1 N s against the sliding.
    engine::Vector6 velocity = engine::Vector6::Zero();
    velocity[0] = 3.0;
    velocity[1] = -1.0;
    const LocalProblem problem = local_form(brick(velocity, 0.5));
    const ContactErrors right = contact_errors(problem, Eigen::Vector3d(2.0, 0.0, -1.0));
    CHECK(right.siconos == Approx(0.0).margin(1e-15));
    CHECK(right.natural_map == Approx(0.0).margin(1e-15));
    CHECK(right.penetration_rate == 0.0);
    CHECK(right.wrong_friction == Approx(0.0).margin(1e-15));
    CHECK(right.dissipation == Approx(2.5));  // 1 N s against 2.5 m/s after the step

    const ContactErrors none = contact_errors(problem, VectorX::Zero(3));
    CHECK(none.penetration_rate == Approx(1.0));
    CHECK(none.cone_violation == 0.0);
    const ContactErrors sideways = contact_errors(problem, Eigen::Vector3d(2.0, 1.0, 0.0));
    CHECK(sideways.wrong_friction == Approx(std::hypot(3.0, 0.5)));  // along its own force, and it does not brake
    CHECK(contact_errors(problem, Eigen::Vector3d(2.0, 0.0, -1.5)).cone_violation == Approx(0.5));
    CHECK(contact_errors(problem, Eigen::Vector3d(2.0, 0.0, -0.5)).wrong_friction == Approx(2.75));
    CHECK(contact_errors(problem, Eigen::Vector3d(2.0, 0.0, 1.0)).dissipation == Approx(-3.5));
}

TEST_CASE("sweeps over rows and over blocks of W find the solution of a brick that slides or sticks") {
    for (const double mu : {0.1, 0.5, 2.0}) {
        engine::Vector6 velocity = engine::Vector6::Zero();
        velocity[0] = 3.0;
        velocity[1] = -1.0;
        velocity[2] = -4.0;
        const GlobalProblem problem = brick(velocity, mu);
        // 5 m/s of sliding, of which friction takes mu times 1 m/s, all of it at most.
        const double share = std::min(mu / 5.0, 1.0);
        const Eigen::Vector3d expected(2.0, 2.0 * 4.0 * share, -2.0 * 3.0 * share);
        INFO(mu);
        const LocalProblem local = local_form(problem);
        const BlockProblem blocks(local);
        for (const BlockSolver& solver : block_solvers()) {
            CHECK((solver.solve(blocks, 3, 50) - expected).norm() < 1e-12);
        }
        const FrozenProblem rows = rows_over_bodies(problem);
        for (const char* const solver : {"pgs", "nncg"})
            CHECK((solved(rows, solver, 50) - expected).norm() < 1e-12);
    }
}

TEST_CASE("there are fifty moments of contacts, each with a name of its own") {
    std::set<std::string> names;
    for (const ContactMoment& moment : contact_moments(false)) names.insert(moment.name);
    CHECK(names.size() == 50);
}

TEST_CASE("problems of our scenes are the same as rows, as M and H, and as rows again") {
    for (const ContactMoment& moment : contact_moments(true)) {
        const FrozenProblem problem = freeze_contacts(moment, [] {});
        INFO(moment.name);
        REQUIRE(problem.system().row_count() > 0);
        const std::optional<GlobalProblem> global = global_form(problem);
        REQUIRE(global);
        const FrozenProblem again = rows_over_bodies(*global);
        REQUIRE(again.system().row_count() == problem.system().row_count());
        // With dt of 1 s forces are impulses, so residuals of scaled forces are equal.
        const double dt = problem.system().dt;
        Random random(7);
        engine::Columns forces = problem.zero();
        for (Eigen::Index j = 0; j < forces.rows(); ++j) forces(j, 0) = random.in(0.0, 50.0);
        const engine::Columns impulses = dt * forces.leftCols(1);
        engine::SystemEquation one = problem.system();
        one.b = one.b.leftCols(1).eval();
        CHECK(natural_residual(again.system(), impulses) ==
              Approx(natural_residual(one, forces.leftCols(1))).epsilon(1e-9));
        // Without impulses the local form has the velocities that the right-hand side asks to change.
        const LocalProblem local = local_form(*global);
        CHECK(local.asymmetry() < 1e-12);
        const VectorX expected = -dt * problem.system().b.col(0);
        CHECK((local.free - expected).norm() <= 1e-9 * std::max(expected.norm(), 1.0));
    }
}

TEST_CASE("a file of FCLib keeps every bit of a problem, global or local") {
    if (skips_without_fclib()) return;
    const Folder folder;
    for (const ContactMoment& moment : contact_moments(true)) {
        INFO(moment.name);
        const GlobalProblem global = *global_form(freeze_contacts(moment, [] {}));
        for (int twice = 0; twice < 2; ++twice)
            write_fclib(global, folder / "problem.hdf5");  // and replaces a file
        const ContactProblem read = read_fclib(folder / "problem.hdf5");
        const GlobalProblem& again = std::get<GlobalProblem>(read);
        CHECK(same(again.mass, global.mass));
        CHECK(same(again.axes, global.axes));
        CHECK(again.force == global.force);
        CHECK(again.given == global.given);
        CHECK(again.mu == global.mu);

        const LocalProblem local = local_form(global);
        write_fclib(local, folder / "local.hdf5");
        const ContactProblem read_local = read_fclib(folder / "local.hdf5");
        CHECK(same(std::get<LocalProblem>(read_local).matrix, local.matrix));
        CHECK(std::get<LocalProblem>(read_local).free == local.free);
        CHECK(std::get<LocalProblem>(read_local).mu == local.mu);
    }
    CHECK(folder.files() == std::vector<std::string>{"local.hdf5", "problem.hdf5"});
}

TEST_CASE("rows over bodies are only for rigid bodies") {
    GlobalProblem soft = brick(engine::Vector6::Zero(), 0.5);
    soft.mass.coeffRef(0, 1) = 0.1;
    CHECK_THROWS_WITH(rows_over_bodies(soft), Catch::Contains("body 0 has no single mass"));
    GlobalProblem odd = brick(engine::Vector6::Zero(), 0.5);
    odd.mass.conservativeResize(5, 5);
    CHECK_THROWS_WITH(rows_over_bodies(odd), Catch::Contains("no multiple of six"));
    // A chain has bars, for which FCLib has no words.
    CHECK_FALSE(global_form(freeze_contacts({"chain", demos::run_of("chain", {{"seconds", "0.1"}})}, [] {})));
}

TEST_CASE("performance profiles have the shares of their definition") {
    const double never = std::numeric_limits<double>::infinity();
    const std::vector<Profile> profiles =
        profiles_of({{"a", {1.0, 4.0, never, never}}, {"b", {2.0, 2.0, 3.0, never}}});
    CHECK(profiles[0].share_within(1.0) == 0.25);
    CHECK(profiles[0].share_within(1.9) == 0.25);
    CHECK(profiles[0].share_within(2.0) == 0.5);
    CHECK(profiles[0].share_within(1e9) == 0.5);
    CHECK(profiles[1].share_within(1.0) == 0.5);
    CHECK(profiles[1].share_within(2.0) == 0.75);
}

TEST_CASE("the report solves exported problems, and shows others beside") {
    if (skips_without_fclib()) return;
    const Folder folder;
    const Ended exported =
        shell(folder, "pushfactor report error --quick --only frozen --export problems --out exported");
    INFO(exported.err);
    REQUIRE(exported.status == 0);
    folder.write("others.csv",
                 "problem,method,iterations,siconos_error,natural_map_m_per_s,penetration_m_per_s,"
                 "wrong_friction_m_per_s,cone_violation_n_s,dissipation_n_m,work_multiply_adds,cpu_s\n"
                 "stack_1_at_0.5s,Siconos NSGS,7,1e-9,1e-9,0,0,0,0,0,0.25\n");
    const Ended ended =
        shell(folder,
              "pushfactor report error --quick --only frozen --problems problems --beside others.csv "
              "--out page");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    const std::string page = folder.read("page/index.html");
    check_page(page);
    CHECK(page.find("Siconos NSGS 250 ms") != std::string::npos);
    const std::string table = folder.read("page/problems.csv");
    for (const char* const name : {"stack_1", "heap_1", "wall_1", "cards_1", "arch_1"}) {
        INFO(name);
        CHECK(table.find(name) != std::string::npos);
    }
    CHECK(std::filesystem::exists(folder / "page/profile_1e-04.dat"));
}

TEST_CASE("what is no contact problem is refused in one line") {
    const Folder folder;
    folder.write("text.hdf5", "no HDF5");
    std::filesystem::create_directory(folder / "empty");
    folder.write("others.csv", "problem,method\n");
    const auto refused = [&](const std::string& arguments, const std::string& words) {
        const Ended ended = shell(folder, "pushfactor report error --quick --only frozen " + arguments);
        INFO(arguments << ": " << ended.err);
        CHECK(ended.status == 2);
        CHECK(lines_of(ended.err).size() == 1);
        CHECK(ended.err.find(words) != std::string::npos);
    };
    refused("--problems empty", "--problems empty: must have files that end in .hdf5");
    refused("--beside others.csv", "--beside others.csv: line 1: must be scene,method,");
    if (skips_without_fclib()) {
        refused("--problems text.hdf5", "install libfclib-dev and libhdf5-dev");
        return;
    }
    refused("--problems text.hdf5", "text.hdf5: must be a file of FCLib (HDF5)");
    refused("--problems none.hdf5", "none.hdf5: must be a file of FCLib (HDF5)");
}
