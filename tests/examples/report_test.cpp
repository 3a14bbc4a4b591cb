// A report, as demos/EXTENDING.md shows it.
#include "demos/options/named_run.h"
#include "demos/reports/study.h"
#include "demos/runs/measurements.h"
#include "demos/scenes/catalogue.h"
#include "tests/catch.h"
#include "tests/demos/csv.h"
#include "tests/demos/program.h"

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::demos::reports;
using namespace pushfactor::tests;

namespace {

// [example: report]
// One scene under every solver: solvers.csv and a page.
void make_solvers(StudyRun& run) {
    const std::string scene = "heavy-on-light";
    const std::string seconds = run.quick() ? "0.5" : "5";
    Table table{{"solver", "residual_m_per_s_median", "max_penetration_m", "outcome"}};
    SectionContent content;
    content.caption = scene + ", " + seconds + " s, 25 iterations where a solver counts them.";
    content.files = {"solvers.csv"};
    run.begin(engine::solvers::solver_table().size());
    for (const engine::solvers::SolverEntry& solver : engine::solvers::solver_table()) {
        const OptionTexts options{{"seconds", seconds}, {"solver", std::string(solver.name)}};
        Simulation simulation(run_of(scene, options));
        Measurements measurements(simulation);
        const bool finite = play_to_end(simulation, run.check(), measurements);
        table.rows.push_back({solver.name, measurements.median_residual(), measurements.max_penetration(),
                              finite ? name_of(measurements.outcome()) : "non-finite"});
        content.commands.push_back(command_text("run", scene, options));
        run.count_run();
    }
    run.write("solvers.csv", csv_text(table));
    content.table = page_lines(table);
    run.sections = {{"solvers", "Solvers", content}};
    run.write_page("One scene, every solver.");
}

Study solvers_study() {
    return {.name = "solvers", .title = "solvers", .parts = {}, .make = make_solvers};
}
// [end]

}  // namespace

TEST_CASE("example: the report on solvers has a line each, and the exact one leaves the smallest residual") {
    const Folder folder;
    make_study(solvers_study(), {.folder = folder.path(), .quick = true});
    CHECK(folder.files() == std::vector<std::string>{"index.html", "solvers.csv"});
    const auto table = table_of(folder.read("solvers.csv"));
    REQUIRE(table.size() == engine::solvers::solver_table().size() + 1);
    const auto residual = [&](const std::string& solver) {
        for (const auto& line : table) {
            if (line.at(0) == solver) return std::stod(line.at(1));
        }
        throw std::out_of_range(solver);
    };
    for (std::size_t i = 1; i < table.size(); ++i) {
        CHECK(table[i].size() == 4);
        CHECK(residual("direct") <= residual(table[i][0]));
        CHECK(folder.read("index.html").find(table[i][0]) != std::string::npos);
    }
    CHECK(residual("direct") < 1e-3 * residual("jacobi"));
}
