// The rows of a step as the page in a browser shows them.
#include "demos/pictures/live/microscope.h"

#include "demos/base/text/errors.h"
#include "demos/options/named_run.h"
#include "tests/catch.h"
#include "tests/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

using namespace pushfactor;
using namespace pushfactor::demos;
using pictures::live::microscope;

namespace {

double bound(const Json& value, double none) {
    return value.is_null() ? none : value.get<double>();
}

// One sweep of 7.1.1 as printed, on the dense matrix.
void sweep(const Json& seen, std::size_t column, std::vector<double>& lambda) {
    for (std::size_t j = 0; j < lambda.size(); ++j) {
        double error = seen["b"][column][j];
        for (std::size_t i = 0; i < lambda.size(); ++i) error -= seen["A"][j][i].get<double>() * lambda[i];
        const Json& row = seen["rows"][j];
        const double factor = row["of_row"] < 0 ? 1.0 : lambda[row["of_row"].get<std::size_t>()];
        const double low = bound(row["c_min"], -std::numeric_limits<double>::infinity()) * factor;
        const double high = bound(row["c_max"], std::numeric_limits<double>::infinity()) * factor;
        lambda[j] = std::max(std::min(lambda[j] + error / seen["diagonal"][j].get<double>(), high), low);
    }
}

}  // namespace

TEST_CASE("the sweeps of the microscope end with the step's forces to the last bit, and are 7.1.1 on A and b") {
    tests::Random random(52);
    int rows = 0;
    for (int draw = 0; draw < 60; ++draw) {
        const auto one_of = [&](const std::vector<std::string>& words) {
            return words[static_cast<std::size_t>(random.in(0.0, static_cast<double>(words.size())))];
        };
        const OptionTexts options{{"preset", "paper"},
                                  {"count", one_of({"1", "2", "3"})},
                                  {"gap", fmt::format("{:.2f}", random.in(-1.0, 0.2))},
                                  {"push", one_of({"none", "persistent", "single-frame"})},
                                  {"beta", fmt::format("{:.2f}", random.in(0.0, 1.0))},
                                  {"friction-model", one_of({"paper", "coulomb"})},
                                  {"friction", one_of({"0", "0.3"})},
                                  {"warm-start", one_of({"off", "on"})},
                                  {"iterations", one_of({"1", "7", "25"})},
                                  {"row-order", one_of({"reverse", "bottom-up"})}};
        INFO(command_text("run", "intersecting-stack", options));
        Simulation run(run_of("intersecting-stack", options));
        const int steps = 1 + static_cast<int>(random.in(0.0, 20.0));
        for (int step = 0; step < steps; ++step) run.advance();
        if (run.scene().world.rows().empty()) continue;  // in the air
        const Json seen = microscope(run);
        const engine::Columns& used = run.scene().world.lambda();
        const auto count = static_cast<std::size_t>(used.rows());
        REQUIRE(seen["rows"].size() == count);
        REQUIRE(seen["lambda"].size() == static_cast<std::size_t>(used.cols()));
        for (std::size_t column = 0; column < seen["lambda"].size(); ++column) {
            const Json& sweeps = seen["lambda"][column];
            REQUIRE(sweeps.size() == static_cast<std::size_t>(run.settings().iterations) + 1);
            std::vector<double> lambda = sweeps[0];
            double largest = 1.0;
            for (std::size_t k = 1; k < sweeps.size(); ++k) {
                sweep(seen, column, lambda);
                for (std::size_t j = 0; j < count; ++j) {
                    largest = std::max(largest, std::abs(lambda[j]));
                    CHECK(std::abs(sweeps[k][j].get<double>() - lambda[j]) <= 1e-9 * largest);
                }
            }
            for (std::size_t j = 0; j < count; ++j) {
                const double last = sweeps.back()[j];
                const double step = used(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(column));
                CHECK(std::bit_cast<std::uint64_t>(last) == std::bit_cast<std::uint64_t>(step));
            }
        }
        rows += static_cast<int>(count);
    }
    CHECK(rows > 500);
}

TEST_CASE("the microscope tells how the bodies moved in the step: with the push, and what they keep of it") {
    Simulation run(run_of("intersecting-stack",
                          {{"preset", "paper"}, {"push", "single-frame"}, {"count", "2"}, {"iterations", "400"}}));
    run.advance();
    const Json seen = microscope(run);
    // 5.3.1: the lower cube overlaps the ground by 1.2 m, the upper one the lower by 0.4 m; beta is 0.2.
    const auto height = [&](std::size_t body, const char* when) {
        return seen["bodies"][body][when]["position"][1].get<double>();
    };
    CHECK(height(1, "after") - height(1, "before") == Approx(0.2 * 1.2).epsilon(1e-6));
    CHECK(height(2, "after") - height(2, "before") == Approx(0.2 * 1.6).epsilon(1e-6));
    for (const std::size_t body : {1u, 2u}) {
        CHECK(std::abs(seen["bodies"][body]["after"]["velocity"][1].get<double>()) < 1e-9);
    }
    CHECK(seen["contacts"].size() == 8);
}

TEST_CASE("the microscope refuses what it cannot show: no step, another solver, small steps, a cone, many rows") {
    const auto refuses = [](const OptionTexts& options, int steps, const std::string& words) {
        Simulation run(run_of("intersecting-stack", options));
        for (int step = 0; step < steps; ++step) run.advance();
        INFO(words);
        try {
            microscope(run);
            FAIL_CHECK("was not refused");
        } catch (const UsageError& error) {
            INFO(error.what());
            CHECK(std::string(error.what()).find(words) != std::string::npos);
        }
    };
    refuses({{"preset", "paper"}}, 0, "step 0: must be at least 1");
    refuses({{"preset", "paper"}, {"solver", "direct"}}, 1, "--solver direct: must be pgs");
    refuses({{"preset", "paper"}, {"substeps", "2"}}, 1, "--substeps 2: must be 1");
    refuses({{"preset", "paper"}, {"scheme", "small-steps"}}, 1, "--scheme small-steps: must be whole");
    refuses({{"preset", "paper"}, {"friction-model", "cone"}}, 1,
            "--friction-model cone: must be paper or coulomb");
    refuses({{"preset", "paper"}, {"count", "20"}}, 1, "must be at most 120");
}
