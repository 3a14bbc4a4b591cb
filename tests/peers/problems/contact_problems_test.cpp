// Contact problems in FCLib's terms: our rows say the same, errors have their closed forms, the page shows all
// solvers.
#include "demos/reports/error/error.h"
#include "engine/solvers/solver.h"
#include "tests/catch.h"
#include "tests/demos/pages/check_page.h"
#include "tests/demos/program.h"
#include "tests/peers/problems/block_solvers.h"
#include "tests/peers/problems/problem_report.h"
#include "tests/peers/problems/profiles.h"
#include "tests/random.h"

#include <set>

using namespace pushfactor;
using namespace pushfactor::demos::reports::error;
using namespace pushfactor::tests;
using namespace pushfactor::tests::problems;
using engine::VectorX;

namespace {

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
        const FrozenProblem problem = freeze(moment.name, moment.choices, [] {});
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

TEST_CASE("rows over bodies are only for rigid bodies") {
    GlobalProblem soft = brick(engine::Vector6::Zero(), 0.5);
    soft.mass.coeffRef(0, 1) = 0.1;
    CHECK_THROWS_WITH(rows_over_bodies(soft), Catch::Contains("body 0 has no single mass"));
    GlobalProblem odd = brick(engine::Vector6::Zero(), 0.5);
    odd.mass.conservativeResize(5, 5);
    CHECK_THROWS_WITH(rows_over_bodies(odd), Catch::Contains("no multiple of six"));
    // A chain has bars, for which FCLib has no words.
    CHECK_FALSE(global_form(freeze({"chain", "chain", {{"seconds", "0.1"}}}, [] {})));
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

TEST_CASE("the page has the solvers of others beside ours") {
    const Folder folder;
    engine::Vector6 velocity = engine::Vector6::Zero();
    velocity[1] = -1.0;
    const auto other = [](const LocalProblem& problem, bool) -> std::vector<ProblemPoint> {
        return {{.problem = problem.title,
                 .method = "Siconos NSGS",
                 .iterations = 7,
                 .errors = {.siconos = 1e-9},
                 .cpu = 0.25}};
    };
    LocalProblem local = local_form(brick(velocity, 0.5));
    local.title = "W alone";
    report_problems({brick(velocity, 0.5), local}, true, other, folder.path());
    const std::string page = folder.read("index.html");
    check_page(page);
    CHECK(page.find("Siconos NSGS 250 ms") != std::string::npos);
    const std::string table = folder.read("problems.csv");
    for (const char* const cells :
         {"brick,pgs,", "brick,direct,", "brick,\"pgs, blocks\",", "brick,Siconos NSGS,7,1e-09,"}) {
        INFO(cells);
        CHECK(table.find(cells) != std::string::npos);
    }
    CHECK(std::filesystem::exists(folder / "profile_1e-04.dat"));
}
