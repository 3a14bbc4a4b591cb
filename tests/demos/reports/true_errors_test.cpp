// The errors of the reports: zero for exact results, known for known deviations.
#include "demos/base/text/errors.h"
#include "demos/reports/error/error.h"
#include "tests/catch.h"
#include "tests/engine/rows.h"

#include <cmath>
#include <map>
#include <set>
#include <tuple>

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::demos::reports::error;

namespace {

// The errors of a run, by name.
std::map<std::string, double> errors_of(const std::string& scene, const OptionTexts& options, MakeTrueError make) {
    const Choices choices = run_of(scene, options);
    Simulation run(choices);
    TrueError error = make(run);
    while (run.sample().step < whole_steps(choices.settings)) {
        run.advance();
        error.observe(run);
    }
    std::map<std::string, double> errors;
    for (const NamedError& each : error.result()) errors[each.name] = each.value;
    return errors;
}

const OptionTexts solved_exactly{
    {"slop", "0"}, {"solver", "direct"}, {"iterations", "20000"}, {"tolerance", "1e-11/1e-11"}};

OptionTexts exactly(OptionTexts options) {
    options.insert(options.end(), solved_exactly.begin(), solved_exactly.end());
    return options;
}

}  // namespace

TEST_CASE("the force error is zero for the converged forces and known for perturbed ones") {
    const tests::Column column(3);
    engine::SystemEquation system;
    build_system(column.bodies, column.rows, 1.0 / 60.0, system);
    engine::Columns exact(3, 1);
    exact << 30, 20, 10;
    CHECK(natural_residual(system, exact) < 1e-12);
    CHECK(force_error(system, exact, exact) == 0.0);
    // A scales both sides alike.
    CHECK(*force_error(system, 1.01 * exact, exact) == Approx(0.01).epsilon(1e-12));
    // One row wrong by 1 N: A_11 = 1/kg, and lambda*^T A lambda* = b^T lambda* = 10 * 30.
    engine::Columns perturbed = exact;
    perturbed(0, 0) += 1.0;
    CHECK(*force_error(system, perturbed, exact) == Approx(std::sqrt(1.0 / 300.0)).epsilon(1e-12));
    CHECK(!force_error(system, exact, engine::Columns::Zero(3, 1)));
}

TEST_CASE("the converged forces are the weights of a column, and of scenes all forces to 1e-10 m/s") {
    const tests::Column column(10);
    engine::SystemEquation system;
    build_system(column.bodies, column.rows, 1.0 / 60.0, system);
    const auto forces = converged_forces(system, engine::Columns::Zero(10, 1));
    REQUIRE(forces);
    for (int i = 0; i < 10; ++i) CHECK((*forces)(i, 0) == Approx((10.0 - i) * 10.0).epsilon(1e-9));

    // Bars that hold each other through contacts, and balls that slide: sweeps alone stall at 1e-9 and 1e-5 m/s.
    const OptionTexts cold{{"tolerance", "0"}, {"warm-start", "off"}, {"friction-model", "paper"}};
    const OptionTexts warm{{"tolerance", "0"}, {"iterations", "100"}, {"friction-model", "paper"}};
    for (const auto& [scene, options, first, last] :
         {std::tuple{"intersecting-stack", cold, 1, 6}, std::tuple{"pendulum-grid", cold, 12, 18},
          std::tuple{"funnel", warm, 114, 120}}) {
        INFO(scene);
        const Choices choices = run_of(scene, options);
        Simulation run(choices);
        for (int step = 1; step <= last; ++step) {
            run.advance();
            if (step < first) continue;
            const engine::World& world = run.scene().world;
            const auto converged = converged_forces(world.system(), world.lambda());
            REQUIRE(converged);
            CHECK(natural_residual(world.system(), *converged) <= 1e-10);
        }
    }
}

TEST_CASE("a sweep contracts the error of a column of balls by cos^2(pi / 2n)") {
    for (const auto& [iterations, more] : {std::pair{"150", "151"}, std::pair{"200", "201"}}) {
        const auto after = [](const char* sweeps) {
            return errors_of("sphere_column",
                             {{"solver", "pgs"},
                              {"push", "none"},
                              {"warm-start", "off"},
                              {"tolerance", "0"},
                              {"iterations", sweeps},
                              {"seconds", "0.02"}},
                             column_error)["force_error_first_step"];
        };
        // Measured to 6 digits.
        CHECK(after(more) / after(iterations) == Approx(column_contraction(10)).epsilon(0.01));
        CHECK(after(more) / after(iterations) == Approx(column_contraction(10)).epsilon(1e-4));
    }
    CHECK(column_contraction(5) == Approx(0.9045).margin(1e-4));
}

TEST_CASE("the parting stack has no error when it is solved exactly, under each push") {
    for (const std::string push : {"single-frame", "persistent"}) {
        INFO(push);
        const auto errors =
            errors_of("intersecting-stack", exactly({{"seconds", "0.5"}, {"push", push}}), parting_error);
        CHECK(errors.at("position_rms_m") < 1e-6);
        CHECK(errors.at("max_upward_speed_m_per_s") < 1e-6);
    }
    CHECK(errors_of("intersecting-stack", {{"seconds", "0.5"}}, parting_error).at("position_rms_m") > 1e-3);
}

TEST_CASE("the closed form of parting cubes is that of the paper's facts") {
    const engine::Correction persistent{engine::PushKind::persistent, 0.2};
    const PartingCube fifth{.start = 8.0, .rest = 10.8, .push = persistent, .dt = 1.0 / 60.0};
    CHECK(fifth.height(30) == Approx(23.592).margin(1e-3));
    CHECK(fifth.upward_speed(30) == Approx(28.767).margin(1e-3));
    PartingCube gently = fifth;
    gently.push.kind = engine::PushKind::single_frame;
    CHECK(gently.height(30) == Approx(10.797).margin(1e-3));
    CHECK(gently.upward_speed(30) == 0.0);
}

TEST_CASE("a stack that is solved exactly rests where it must and carries its weight, aligned or not") {
    for (const char* jitter : {"0", "0.01", "0.1"}) {
        INFO(jitter);
        const OptionTexts fall = exactly(
            {{"seconds", "4"}, {"gap", "0.05"}, {"jitter", jitter}, {"seed", "2"}, {"friction-model", "paper"}});
        const auto errors = errors_of("stack", fall, rest_error);
        CHECK(errors.at("rest_position_rms_m") < 1e-6);
        CHECK(errors.at("max_sideways_m") < 1e-6);
        CHECK(errors.at("bottom_force_rms") < 1e-6);
    }
    const auto coarse = errors_of("stack", {{"seconds", "4"}, {"iterations", "2"}, {"solver", "pgs"}}, rest_error);
    CHECK(coarse.at("rest_position_rms_m") > 1e-3);
}

TEST_CASE("an aligned stack flatters Jacobi, so that of the report is jittered") {
    const auto sideways = [](OptionTexts options) {
        options.insert(options.end(), {{"solver", "jacobi"}, {"tolerance", "0"}, {"slop", "0"}, {"seconds", "4"}});
        return errors_of("stack", options, rest_error).at("max_sideways_m");
    };
    CHECK(sideways({}) < 1e-9);
    for (const Experiment& sweep : error_experiments(false)) {
        if (sweep.scene == "stack") CHECK(sideways(options(sweep.common + " seconds=" + sweep.seconds)) > 1e-3);
    }
}

TEST_CASE("free bodies: half a kick makes the flight exact, and each rotation has its order") {
    const auto errors = [](const std::string& rotation, const std::string& dt, const std::string& kick) {
        return errors_of("free_body", {{"rotation", rotation}, {"dt", dt}, {"start-kick", kick}}, free_error);
    };
    for (const auto& [rotation, order] :
         {std::pair{"paper", 1.0}, std::pair{"exponential", 1.0}, std::pair{"splitting", 2.0}}) {
        INFO(rotation);
        const auto coarse = errors(rotation, "1/960", "on"), fine = errors(rotation, "1/1920", "on");
        CHECK(coarse.at("flight_rms_m") < 1e-12);
        CHECK(std::log2(coarse.at("angle_rms_deg") / fine.at("angle_rms_deg")) == Approx(order).margin(0.1));
        CHECK(coarse.at("corners_rms_m") > 0.1 * coarse.at("angle_rms_deg") * 3.14159 / 180);
    }
    // Without the kick v lags by half a step, and the position by g t dt / 2: 10 m/s^2, RMS over 2 s, 1/60 s.
    CHECK(errors("splitting", "1/60", "off").at("flight_rms_m") ==
          Approx(10.0 / 120.0 * 2.0 / std::sqrt(3.0)).epsilon(0.02));
    CHECK(errors("splitting", "1/240", "on").at("turning_energy_max") < 0.01);
    CHECK(errors("paper", "1/240", "on").at("turning_energy_max") > 0.02);
}

TEST_CASE("every method is one that the program has, with values and a name of its own") {
    const Method unknown{.name = "a", .differs = "solver=magic", .knob = "iterations", .colour = "blue"};
    CHECK_THROWS_AS(run_at(error_experiments(true).front(), unknown, "5"), UsageError);
    for (Experiment sweep : error_experiments(false)) {
        INFO(sweep.scene);
        // Finding the lengths of all fifty pendulums takes long.
        if (sweep.scene == "pendulum-wave") sweep.common += " count=1";
        std::set<std::string> names;
        for (const Method& method : sweep.methods) {
            CHECK(names.insert(method.name).second);
            CHECK(!method.values.empty());
            for (const std::string& value : method.values) CHECK_NOTHROW(run_at(sweep, method, value));
        }
        CHECK(!names.empty());
    }
}

TEST_CASE("a run that breaks is named, and its time is that of the steps before") {
    Experiment sweep{.scene = "chain",
                     .common = "end-mass=1000000 distance-beta=1",
                     .seconds = "20",
                     .error = converged_error,
                     .timed_runs = 1};
    const Method method{.name = "pgs", .differs = "preset=paper", .knob = "iterations", .colour = "blue"};
    const ErrorPoint point = run_point(sweep, method, "25", [] {});
    CHECK(point.failed);
    CHECK(csv_text(table_of(std::vector{point})).find("," + point.outcome + "\n") != std::string::npos);
    CHECK(point.cpu.median > 0.0);
}

TEST_CASE("the 95th percentile of few values is the largest, of a hundred the 95th") {
    CHECK(percentile_95({3, 1, 2, 5, 4}) == 5.0);
    std::vector<double> values;
    for (int i = 100; i > 0; --i) values.push_back(i);
    CHECK(percentile_95(values) == 95.0);
}

TEST_CASE("the chain's error falls with the square of the step, and the pile's is the depth that summaries state") {
    const auto error = [](const char* dt) {
        return errors_of("chain", {{"end-mass", "1000"}, {"seconds", "1"}, {"dt", dt}, {"scheme", "rattle"}},
                         chain_error)
            .at("position_rms_m");
    };
    const double coarse = error("1/480"), fine = error("1/960");
    CHECK(fine < 1e-4);
    CHECK(std::log2(coarse / fine) == Approx(2.0).margin(0.1));

    const auto overlaps = errors_of("pile_of_cubes", {{"seconds", "1"}, {"slop", "0"}}, overlap_error);
    CHECK(overlaps.at("deepest_overlap_median_m") > 0.0);
    CHECK(overlaps.at("deepest_overlap_median_m") < overlaps.at("deepest_overlap_m"));
    // Two sweeps leave the cubes deeper in each other, where no step is taken again for that.
    const auto coarse_overlaps = errors_of("pile_of_cubes",
                                           {{"seconds", "1"},
                                            {"slop", "0"},
                                            {"solver", "pgs"},
                                            {"iterations", "2"},
                                            {"tolerance", "0"},
                                            {"substeps", "1"}},
                                           overlap_error);
    CHECK(coarse_overlaps.at("deepest_overlap_median_m") > 2.0 * overlaps.at("deepest_overlap_median_m"));
}
