// Frozen problems: a written problem reads back unchanged.
#include "demos/base/text/errors.h"
#include "demos/reports/error/error.h"
#include "engine/solvers/solver.h"
#include "tests/catch.h"
#include "tests/demos/program.h"
#include "tests/peers/problems/frozen_file.h"

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::demos::reports::error;

namespace {

double residual_after(const FrozenProblem& problem, const engine::Columns& start, int iterations) {
    engine::Columns lambda = start;
    engine::solvers::make_solver("pgs")->solve(
        problem.system(), {.iterations = iterations, .tolerance_high = 0, .tolerance_low = 0}, lambda);
    return natural_residual(problem.system(), lambda);
}

std::string complaint(const tests::Folder& folder, const std::string& text) {
    folder.write("problem.json", text);
    try {
        tests::problems::read_frozen(folder / "problem.json");
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a frozen problem reads back with the same residuals, bit for bit") {
    const tests::Folder folder;
    const std::vector<FrozenMoment> moments{
        {"parting", "intersecting-stack", {{"seconds", "0.1"}}},
        {"coulomb", "stack", {{"friction-model", "coulomb"}, {"seconds", "0.6"}}},
        {"chain", "chain", {{"seconds", "0.1"}}},
    };
    for (const FrozenMoment& moment : moments) {
        INFO(moment.name);
        const FrozenProblem problem = freeze(moment, [] {});
        REQUIRE(problem.system().row_count() > 0);
        folder.write("problem.json", problem.text());
        const FrozenProblem again = tests::problems::read_frozen(folder / "problem.json");
        CHECK(again.name() == moment.name);
        CHECK(again.text() == problem.text());
        for (const int iterations : {1, 5, 25}) {
            CHECK(residual_after(again, again.zero(), iterations) ==
                  residual_after(problem, problem.zero(), iterations));
            CHECK(residual_after(again, again.guess(), iterations) ==
                  residual_after(problem, problem.guess(), iterations));
        }
        CHECK(residual_after(problem, problem.zero(), 25) > 0.0);
    }
}

TEST_CASE("frozen points: more sweeps leave less, warm starts are nearer, and the plot leaves dense out") {
    // At 4 s a ball still rolls by 0.6 m/s, and a sweep from the last forces may leave more than one from none.
    const FrozenProblem problem = freeze({"settled", "funnel", {{"seconds", "8"}, {"scheme", "whole"}}}, [] {});
    const Table table = solve_frozen(problem, true);
    const auto lines = exact_rows(table);
    const auto residual = [&](const std::string& method, int iterations) {
        for (const auto& cells : lines) {
            if (cells[1] == method && cells[2] == std::to_string(iterations)) return std::stod(cells[3]);
        }
        FAIL("no such point");
        return 0.0;
    };
    CHECK(residual("pgs, cold", 100) < 0.1 * residual("pgs, cold", 1));
    CHECK(residual("pgs, warm", 1) < residual("pgs, cold", 1));
    CHECK(csv_text(table).starts_with("problem,method,iterations,residual_m_per_s,work_multiply_adds\nsettled,"));
    for (const WorkLine& line : lines_of(lines)) CHECK(!line.name.starts_with("dense"));
}

TEST_CASE("a frozen problem that is wrong is refused with the file, the place and what is allowed") {
    const tests::Folder folder;
    const std::string good = freeze({"chain", "chain", {{"links", "2"}, {"seconds", "0.1"}}}, [] {}).text();
    CHECK(complaint(folder, good).empty());
    const auto changed = [&good](const std::string& from, const std::string& to) {
        std::string text = good;
        const auto at = text.find(from);
        REQUIRE(at != std::string::npos);
        return text.replace(at, from.size(), to);
    };
    CHECK(complaint(folder, "{").find("is not JSON") != std::string::npos);
    CHECK(complaint(folder, changed("\"version\": 1", "\"version\": 2")).find("version 2: must be 1") !=
          std::string::npos);
    CHECK(complaint(folder, changed("\"dt_s\": 0.0", "\"dt_s\": -0.0")).find("dt_s") != std::string::npos);
    CHECK(complaint(folder, changed("\"body_b\": ", "\"body_b\": 9")).find("rows[0].body_b") != std::string::npos);
    CHECK(complaint(folder, changed("\"j_a\"", "\"j\"")).find("rows[0].j_a: is missing") != std::string::npos);
    CHECK_THROWS_AS(tests::problems::read_frozen(folder / "nothing.json"), UsageError);
}
