// The cost report: all files, the same counts twice; and the ledger of the wave.
#include "demos/options/named_run.h"
#include "demos/reports/cost/cost.h"
#include "tests/catch.h"
#include "tests/demos/csv.h"
#include "tests/demos/pages/check_page.h"
#include "tests/demos/program.h"

#include <numeric>

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::demos::reports::cost;
using namespace pushfactor::tests;

namespace {

using Method = engine::IslandSolver::Method;

constexpr const char* two_scenes = "pushfactor report cost --quick --only intersecting-stack,pendulum-wave --out .";

// cost.csv by column names, without the line about the machine.
struct Table {
    std::vector<std::string> names;
    std::vector<std::vector<std::string>> lines;

    explicit Table(const std::string& csv) : lines(table_of(csv)) {
        REQUIRE(lines.size() > 2);
        CHECK(lines[0][0].starts_with("# pushfactor "));
        names = lines[1];
        lines.erase(lines.begin(), lines.begin() + 2);
    }

    std::size_t column(const std::string& name) const {
        const auto found = std::find(names.begin(), names.end(), name);
        REQUIRE(found != names.end());
        return static_cast<std::size_t>(found - names.begin());
    }
    const std::string& at(std::size_t line, const std::string& name) const {
        return lines.at(line).at(column(name));
    }

    void drop_times() {
        const std::size_t first = column("step_us");
        for (auto& line : lines) {
            line.erase(line.begin() + static_cast<std::ptrdiff_t>(first), line.end() - 1);
        }
    }
};

Ledger counted(const Choices& choices, double start) {
    const Choices moment = moment_at(choices, start, [] {});
    return {.parts = parts_of(build_scene(moment), moment.settings), .counts = count_steps(moment), .times = {}};
}

}  // namespace

TEST_CASE("one command makes the ledger, its plots and a page, and a second one the same counts") {
    const Folder folder, again;
    const Ended ended = shell(folder, two_scenes);
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    CHECK(ended.out == "./index.html\n");
    check_page(folder.read("index.html"));
    REQUIRE(shell(again, two_scenes).status == 0);

    Table table(folder.read("cost.csv")), same(again.read("cost.csv"));
    CHECK(table.names.back() == "command");
    REQUIRE(table.lines.size() == 4);
    for (const auto& line : table.lines) CHECK(line.size() == table.names.size());
    const double contacts = std::stod(table.at(0, "contact_rows"));
    CHECK(std::stod(table.at(0, "us_per_contact")) * contacts ==
          Approx(std::stod(table.at(0, "step_us"))).epsilon(0.01));
    const double bytes = std::stod(table.at(0, "bytes_per_contact"));
    CHECK(bytes > 3.0 * sizeof(engine::ConstraintRow));
    CHECK(bytes * contacts < 1e6);
    CHECK(table.at(2, "scene") == "pendulum-wave");
    for (const char* per_contact : {"us_per_contact", "bytes_per_contact"}) CHECK(table.at(2, per_contact).empty());
    for (const char* file : {"cost_stages", "cost_everything"}) {
        CHECK(folder.read("index.html").find(std::string("<img src=\"") + file + ".png\"") != std::string::npos);
        for (const char* ending : {".png", ".svg", ".dat"}) {
            CHECK(std::filesystem::file_size(folder / (std::string(file) + ending)) > 100);
        }
    }
    table.drop_times();
    same.drop_times();
    CHECK(table.lines == same.lines);
}

TEST_CASE("a command of the ledger ends with the rows that the ledger counted") {
    const Folder folder;
    REQUIRE(shell(folder, two_scenes).status == 0);
    const Table table(folder.read("cost.csv"));
    for (std::size_t i = 0; i < table.lines.size(); ++i) {
        INFO(table.at(i, "command"));
        REQUIRE(shell(folder, table.at(i, "command") + " --csv steps.csv").status == 0);
        const auto steps = table_of(folder.read("steps.csv"));
        const auto& names = steps.front();
        const auto rows = static_cast<std::size_t>(std::find(names.begin(), names.end(), "rows") - names.begin());
        const double counted_rows = std::stod(table.at(i, "contact_rows")) +
                                    std::stod(table.at(i, "friction_rows")) +
                                    std::stod(table.at(i, "distance_rows")) + std::stod(table.at(i, "joint_rows"));
        CHECK(std::stod(steps.back().at(rows)) == counted_rows);
    }
}

TEST_CASE("the wave makes no pair, no contact and one column, and each part of everything is seen in the ledger") {
    const Choices wave = run_of("pendulum-wave", {});
    const Ledger own = counted(wave, 1.0);
    CHECK(own.parts.forces == std::vector<std::string>{"gravity"});
    CHECK(own.parts.constraints == std::vector<std::string>{"50 distances"});
    CHECK(own.parts.contacts.empty());
    CHECK(own.parts.step_rules == std::vector<std::string>{"tension", "turning"});
    CHECK(own.counts.pairs == 0.0);
    CHECK(own.counts.touches == 0.0);
    CHECK(own.counts.contact_rows == 0.0);
    CHECK(own.counts.friction_rows == 0.0);
    CHECK(own.counts.distance_rows == 50.0);
    CHECK(own.counts.columns == 1.0);

    Choices all = wave;
    all.description = with_everything(spelled_out(wave));
    all.settings.distances.kind = engine::PushKind::single_frame;
    all.settings.substeps.reset();
    const Ledger everything = counted(all, 1.0);
    CHECK(everything.parts.forces == std::vector<std::string>{"gravity", "poke"});
    CHECK(everything.parts.constraints == std::vector<std::string>{"50 distances", "contacts"});
    CHECK(everything.parts.contacts == std::vector<std::string>{"friction", "restitution", "sweep", "cache"});
    CHECK(everything.parts.step_rules == std::vector<std::string>{"tension", "turning"});
    CHECK(everything.counts.columns == 2.0);
    CHECK(everything.counts.multiply_adds > 1.5 * own.counts.multiply_adds);
}

TEST_CASE("a stack at rest keeps its forces: it checks them and neither solves nor sweeps") {
    const Counts at_rest = counted(run_of("stack", {{"friction-model", "paper"}, {"gap", "-0.0001"}}), 10.0).counts;
    CHECK(at_rest.pairs == 5.0);
    CHECK(at_rest.touches == 5.0);
    CHECK(at_rest.contact_rows == 20.0);
    CHECK(at_rest.friction_rows == 40.0);
    CHECK(at_rest.islands[static_cast<std::size_t>(IslandKind::thread)].of(Method::kept) == 1.0);
    CHECK(at_rest.islands[static_cast<std::size_t>(IslandKind::thread)].all() == 1.0);
    CHECK(at_rest.sweeps == 0.0);
    CHECK(at_rest.row_updates == 0.0);
    CHECK(at_rest.multiply_adds == 12.0 * 60.0);  // one look at each row

    const Counts swept = counted(run_of("stack", {{"solver", "pgs"}, {"tolerance", "0"}}), 10.0).counts;
    CHECK(swept.islands[static_cast<std::size_t>(IslandKind::thread)].of(Method::swept) == 1.0);
    CHECK(swept.sweeps == 25.0);
    CHECK(swept.row_updates == 25.0 * 60.0 * swept.columns);
    CHECK(swept.multiply_adds == 24.0 * swept.row_updates);
}

TEST_CASE("scenes side by side do the work of the sum of their parts, and none moves for another's sake") {
    for (const Neighbours& scenes : neighbours(true)) {
        INFO(scenes.together.name);
        const SumOfParts sum = measure(scenes, 1, [] {});
        CHECK(sum.islands > 1.0);
        CHECK(sum.parts_multiply_adds > 1000.0);
        CHECK(sum.together_multiply_adds == Approx(sum.parts_multiply_adds).epsilon(1e-12));
        CHECK(sum.moved == 0.0);
        CHECK(sum.together_us > 0.0);
    }
}

// It changes what the heap stands on, so that an exact solution would not last: each step tried one, in 25
// factorisations.
TEST_CASE("while a ball rolls over a heap no exact solution is tried in vain") {
    for (const Neighbours& scenes : neighbours(false)) {
        if (scenes.together.name != "tower of 20 and pit of 200 balls") continue;
        CHECK(measure(scenes, 1, [] {}).parts_multiply_adds < 5e6);  // measured 1.7e6, and 5.3e7 with the vain ones
        return;
    }
    FAIL("there is no such pit");
}

TEST_CASE("the ledger counts the islands of a scene by kind and by what is done with them") {
    const auto islands_of = [](const Counts& counts, IslandKind kind) {
        return counts.islands[static_cast<std::size_t>(kind)];
    };
    const Counts wave = counted(run_of("pendulum-wave", {}), 1.0).counts;
    CHECK(islands_of(wave, IslandKind::single).of(Method::swept) == 50.0);
    CHECK(islands_of(wave, IslandKind::thread).all() == 0.0);
    const Counts chain = counted(run_of("chain", {}), 1.0).counts;
    CHECK(islands_of(chain, IslandKind::thread).of(Method::exact) == 1.0);
    const Counts funnel = counted(run_of("funnel", {}), 10.0).counts;
    CHECK(islands_of(funnel, IslandKind::heap).all() == 1.0);
}

TEST_CASE("stages add up in the order of the step, and reading the clock is not among them") {
    CHECK(clock_cost() > 0.0);
    PhaseClock clock(0.0);
    clock.begin();
    clock.rules_ended();
    CHECK(clock.times()[0] > 0.0);
    clock.phase_ended(engine::Phase::integrate);
    CHECK(clock.times().back() > 0.0);
    CHECK(std::accumulate(clock.times().begin() + 1, clock.times().end() - 1, 0.0) == 0.0);
    CHECK(phase_names.size() == 1 + static_cast<std::size_t>(engine::Phase::integrate) + 1);
}

TEST_CASE("an interrupted cost report ends with status 1 and leaves whole files only") {
    check_interrupted("cost", "everything/*.json");
}

TEST_CASE("without gnuplot the cost report has its tables, and an unknown scene is refused") {
    const Folder folder;
    const Ended ended = shell(folder, "PATH=/nowhere pushfactor report cost --quick --only chain --out .");
    INFO(ended.err);
    CHECK(ended.status == 0);
    CHECK(folder.read("index.html").find("apt install gnuplot-nox") != std::string::npos);
    CHECK(std::filesystem::exists(folder / "cost.csv"));
    check_refused("report cost --only funel", "did you mean funnel?");
    CHECK(run_program("report cost --quick --out /dev/null/x").status == 4);
}
