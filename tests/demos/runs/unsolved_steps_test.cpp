// Unsolved steps: counted and reported.
#include "demos/base/text/json.h"
#include "demos/options/named_run.h"
#include "tests/catch.h"
#include "tests/demos/csv.h"
#include "tests/demos/program.h"
#include "tests/scene_fixture.h"

#include <algorithm>
#include <iomanip>
#include <map>
#include <sstream>
#include <tuple>

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::tests;

namespace {

// Balls at rest on bars; those of "torn" are of different lengths between the same two points.
const std::string two_hanging = R"({"version": 1, "name": "hanging", "bodies": [
    {"name": "sound", "shape": "sphere", "radius_m": 0.1, "mass_kg": 1, "position_m": [5, -1, 0]},
    {"name": "torn", "shape": "sphere", "radius_m": 0.1, "mass_kg": 2, "position_m": [0, -1.05, 0]}],
    "distance_constraints": [
    {"a": {"body": "world", "point_m": [5, 0, 0]}, "b": {"body": "sound"}, "length_m": 1},
    {"a": {"body": "world"}, "b": {"body": "torn"}, "length_m": 1},
    {"a": {"body": "world"}, "b": {"body": "torn"}, "length_m": 1.1}]})";

std::vector<double> column_of(const std::string& csv, const std::string& name) {
    const auto table = table_of(csv);
    const auto& header = table.front();
    const auto place = static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
    std::vector<double> column;
    for (std::size_t i = 1; i < table.size(); ++i) column.push_back(std::stod(table[i].at(place)));
    return column;
}

Simulation start(const std::string& scene, const OptionTexts& options) {
    const Choices choices = run_of(scene, options);
    return Simulation(choices);
}

// The velocity errors of the bars after a step, by the bodies that they hold, in a scene of bars only: from the
// momenta, not from forces.
std::map<std::pair<int, int>, double> misses(const Simulation& simulation) {
    const engine::World& world = simulation.scene().world;
    std::map<std::pair<int, int>, double> found;
    for (const engine::ConstraintRow& row : world.rows()) {
        const auto speed = [&](int body, const engine::Vector6& axis) {
            return axis.head<3>().dot(velocity(world.bodies[static_cast<std::size_t>(body)]));
        };
        const double wanted = row.push.correcting + row.push.lasting;
        found[{row.body_a, row.body_b}] =
            std::abs(speed(row.body_a, row.jacobian.a) + speed(row.body_b, row.jacobian.b) - wanted);
    }
    return found;
}

}  // namespace

TEST_CASE("a run that its solver cannot finish counts the steps, names the first and the worst, and says so once") {
    const Folder folder;
    const Ended ended = shell(
        folder, "pushfactor run funnel --solver pgs --iterations 1 --seconds 3 --csv steps.csv --summary s.json");
    REQUIRE(ended.status == 0);
    const std::string csv = folder.read("steps.csv");
    const std::vector<double> unsolved = column_of(csv, "islands_unsolved");
    const std::vector<double> residuals = column_of(csv, "residual_m_per_s");
    const std::vector<double> times = column_of(csv, "time_s");
    REQUIRE(unsolved.size() == 180);
    const auto counts = [](double islands) { return islands > 0.0; };
    const auto count = std::count_if(unsolved.begin(), unsolved.end(), counts);
    const auto first = std::find_if(unsolved.begin(), unsolved.end(), counts) - unsolved.begin();
    const auto worst = std::max_element(residuals.begin(), residuals.end()) - residuals.begin();
    CHECK(count > 50);
    CHECK(count < 180);  // the balls fall freely first
    for (std::size_t i = 0; i < unsolved.size(); ++i) CHECK((unsolved[i] > 0.0) == (residuals[i] > 1e-8));

    const Json summary = parse_json(folder.read("s.json"));
    CHECK(summary["unsolved_steps"] == count);
    CHECK(summary["first_unsolved_step"] == first + 1);
    CHECK(summary["contradicting_steps"] == 0);
    CHECK(summary["residual_m_per_s_worst"] == residuals[static_cast<std::size_t>(worst)]);

    std::ostringstream text;
    text << "pushfactor: warning: funnel: " << count
         << " of 180 steps are not solved to 1e-08 m/s, the first is step " << first + 1 << " ("
         << std::setprecision(4) << times[static_cast<std::size_t>(first)] << " s); the worst residual is "
         << std::setprecision(2) << residuals[static_cast<std::size_t>(worst)] << " m/s in step " << worst + 1
         << " (" << std::setprecision(4) << times[static_cast<std::size_t>(worst)] << " s), between '";
    CHECK_THAT(ended.err, Catch::StartsWith(text.str()) && Catch::EndsWith("'\n"));
    CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
}

TEST_CASE("a run that is solved says nothing and counts nothing") {
    const Ended ended = run_program("run stack --preset exact --seconds 3");
    CHECK(ended.err.empty());
    const Json summary = parse_json(ended.out);
    CHECK(summary["unsolved_steps"] == 0);
    CHECK(summary["first_unsolved_step"].is_null());
    CHECK(summary["contradicting_steps"] == 0);
    CHECK(summary["residual_m_per_s_worst"] < 1e-8);
    CHECK(summary["residual_m_per_s_worst"] >= summary["residual_m_per_s_median"]);
}

TEST_CASE("where there is no tolerance nothing is called unsolved, and the worst residual is reported") {
    const Ended ended = run_program("run stack --preset paper --seconds 3");
    CHECK(ended.err.empty());
    const Json summary = parse_json(ended.out);
    CHECK(summary["unsolved_steps"] == 0);
    CHECK(summary["residual_m_per_s_worst"] > 0.01);
}

TEST_CASE("bars that contradict each other are counted and named, and not those that hang beside them") {
    const Folder folder;
    folder.write("my.json", two_hanging);
    const Ended ended =
        shell(folder, "pushfactor run my.json --preset exact --seconds 1 --csv steps.csv --summary s.json");
    REQUIRE(ended.status == 0);
    const Json summary = parse_json(folder.read("s.json"));
    CHECK(summary["contradicting_steps"] == 60);
    CHECK(summary["unsolved_steps"] == 60);
    for (const double islands : column_of(folder.read("steps.csv"), "islands_unsolved")) CHECK(islands == 1);
    const std::vector<std::string> lines = lines_of(ended.err);
    REQUIRE(lines.size() == 2);
    CHECK_THAT(lines[0],
               Catch::StartsWith("pushfactor: warning: hanging: 60 of 60 steps are not solved to 1e-10 m/s, "
                                 "the first is step 1 (0.01667 s); ") &&
                   Catch::EndsWith("between 'world' and 'torn'"));
    CHECK(
        lines[1] ==
        "pushfactor: warning: hanging: rows contradict each other in 60 of 60 steps, first in step 1 (0.01667 s), "
        "between 'world' and 'torn'");
}

TEST_CASE("the bodies that are named are those of the bar that is most wrong, by the momenta after the step") {
    Simulation chain = start("chain", {{"solver", "pgs"},
                                       {"iterations", "3"},
                                       {"end-mass", "7"},
                                       {"substeps", "1"},
                                       {"distance-push", "persistent"}});
    double largest = 0.0;
    int named = 0;
    for (int i = 0; i < 120; ++i) {
        const Sample& sample = chain.advance();
        const bool worse = sample.count.islands_unsolved > 0 && sample.residual > largest;
        CHECK(sample.worst_unsolved.has_value() == worse);
        if (worse) largest = sample.residual;
        if (!sample.worst_unsolved) continue;
        ++named;
        const double miss = misses(chain).at({sample.worst_unsolved->a, sample.worst_unsolved->b});
        for (const auto& [bodies, other] : misses(chain)) CHECK(miss >= other - 1e-9);
        CHECK(miss == Approx(sample.residual));
    }
    CHECK(named > 10);
    CHECK(named < 120);  // checked in each step that is worse than all before
}

TEST_CASE("of the substeps of a step the one with the most unsolved islands counts") {
    const OptionTexts heap{{"solver", "pgs"}, {"iterations", "3"}};
    OptionTexts halved = heap, whole = heap;
    whole.insert(whole.end(), {{"dt", "1/60"}, {"substeps", "2"}});
    halved.insert(halved.end(), {{"dt", "1/120"}, {"substeps", "1"}});
    Simulation together = start("funnel", whole), alone = start("funnel", halved);
    int last_is_less = 0;
    for (int i = 0; i < 180; ++i) {
        const Sample first = alone.advance();
        const Sample second = alone.advance();
        const Sample& both = together.advance();
        CHECK(both.count.islands_unsolved == std::max(first.count.islands_unsolved, second.count.islands_unsolved));
        CHECK(both.count.islands_exact == second.count.islands_exact);
        CHECK(both.residual == std::max(first.residual, second.residual));
        last_is_less += second.count.islands_unsolved < first.count.islands_unsolved;
    }
    CHECK(last_is_less > 0);
}

TEST_CASE("compared runs are named by what tells them apart, and each says its own") {
    const Folder folder;
    folder.write("my.json", two_hanging);
    const Ended ended =
        shell(folder,
              "pushfactor render my.json --preset exact --compare tolerance=0,1e-9 --seconds 0.5 --at 0.5 "
              "--out frames --size 64x36");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    const std::vector<std::string> lines = lines_of(ended.err);
    CHECK(std::all_of(lines.begin(), lines.end(), [](const std::string& line) {
        return line.starts_with("pushfactor: warning: hanging, tolerance 1e-9: ") ||
               line.starts_with("pushfactor: warning: hanging, tolerance 0: rows contradict");
    }));
    CHECK_THAT(ended.err, Catch::Contains("hanging, tolerance 1e-9: 30 of 30 steps are not solved to 1e-09 m/s"));
    const Json summary = parse_json(folder.read("frames/summary.json"));
    CHECK(summary["panels"][0]["unsolved_steps"] == 0);
    CHECK(summary["panels"][1]["unsolved_steps"] == 30);
}

TEST_CASE("a run whose bars give way or whose energy grows says which option helps, and with that it is silent") {
    for (const auto& [options, words, remedy] :
         {std::tuple{"--end-mass 100", "bars were wrong by up to", "--substeps auto"},
          std::tuple{"--end-mass 1000", "bars were wrong by up to", "--substeps auto"},
          std::tuple{"--end-mass 100 --scheme rattle", "without a source", "--substeps auto"},
          std::tuple{"--end-mass 100 --scheme rattle4", "not finite", "--substeps auto"},
          std::tuple{"--preset paper", "bars were wrong", "--substeps auto with --solver auto"}}) {
        const Ended ended = run_program(std::string("run chain ") + options + " --substeps 1");
        INFO(options << ": " << ended.err);
        CHECK_THAT(ended.err, Catch::Contains(words));
        CHECK_THAT(ended.err, Catch::Contains(std::string("; try ") + remedy + "\n"));
        const Ended helped = run_program(std::string("run chain ") + options + " --substeps auto --solver auto");
        CHECK(helped.err.empty());
    }
}

TEST_CASE("energy from bars that are wrong at the start is said to come from how they are corrected") {
    const Folder folder;
    folder.write("start.json", R"({"version": 1, "name": "start", "bodies": [
        {"name": "ball", "shape": "sphere", "radius_m": 0.1, "mass_kg": 1, "position_m": [0, -1.5, 0]}],
        "distance_constraints": [{"a": {"body": "world"}, "b": {"body": "ball"}, "length_m": 1}]})");
    CHECK_THAT(shell(folder, "pushfactor run start.json --distance-push persistent --substeps 1").err,
               Catch::EndsWith("; try --distance-push curve\n"));
    CHECK(shell(folder, "pushfactor run start.json").err.empty());
}

TEST_CASE("runs that go well are not told to try another option") {
    for (const std::string run : {"stack", "intersecting-stack", "funnel --seconds 3", "pendulum-grid --seconds 2",
                                  "pendulum-wave", "heavy-on-light", "chain --end-mass 30"}) {
        const Ended ended = run_program("run " + run);
        INFO(run << ": " << ended.err);
        CHECK(ended.status == 0);
        CHECK_THAT(ended.err, !Catch::Contains("; try "));
    }
}
