// A report, as demos/README.md shows it.
#include "demos/options/named_run.h"
#include "demos/pages/page.h"
#include "demos/platform/output_file.h"
#include "demos/platform/progress.h"
#include "demos/runs/measurements.h"
#include "demos/scenes/catalogue.h"
#include "demos/text/numbers.h"
#include "tests/catch.h"
#include "tests/demos/csv.h"
#include "tests/demos/program.h"

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::tests;

namespace {

// [example: report]
struct SolversRequest {
    std::filesystem::path folder;
    bool quick = false;  // half a second of each run instead of five
};

// One scene under every solver: solvers.csv and index.html. Throws what errors.h names.
void report_solvers(const SolversRequest& request) {
    make_folder(request.folder);
    const std::string scene = "heavy-on-light";
    const std::string seconds = request.quick ? "0.5" : "5";
    std::string csv = "solver,residual_m_per_s_median,max_penetration_m,outcome\n";
    Section section{.name = "solvers", .heading = "Solvers", .plate = {}};
    section.plate.caption = scene + ", " + seconds + " s, 25 iterations where a solver counts them.";
    section.plate.files = {"solvers.csv"};
    section.plate.table = {{"solver", "median residual [m/s]", "deepest penetration [m]", "outcome"}};
    for (const engine::solvers::SolverEntry& solver : engine::solvers::solver_table()) {
        const OptionTexts options{{"seconds", seconds}, {"solver", std::string(solver.name)}};
        const Choices choices = run_of(scene, options);
        Simulation simulation(choices);
        Measurements measurements(simulation);
        for (long step = 0; step < whole_steps(choices.settings); ++step) {
            stop_if_interrupted("nothing is written");
            simulation.advance();
            measurements.observe(simulation);
        }
        const std::vector<std::string> line{std::string(solver.name), to_text(measurements.median_residual()),
                                            to_text(measurements.max_penetration()),
                                            std::string(name_of(measurements.outcome()))};
        csv += line[0] + "," + line[1] + "," + line[2] + "," + line[3] + "\n";
        section.plate.table.push_back(line);
        section.plate.commands.push_back(command_text("run", scene, options));
    }
    write_file(request.folder / "solvers.csv", csv);
    write_file(request.folder / "index.html",
               page_text("Pushfactor: solvers", "One scene, every solver.", std::vector{section}));
}
// [end]

}  // namespace

TEST_CASE("example: the report on solvers has a line each, and the exact one leaves the smallest residual") {
    const Folder folder;
    report_solvers({.folder = folder.path(), .quick = true});
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
