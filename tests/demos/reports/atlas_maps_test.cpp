// What the maps of the atlas must show with any version of the engine: orderings and closed forms.
#include "demos/reports/atlas/atlas.h"
#include "tests/catch.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace pushfactor::demos;
using namespace pushfactor::demos::reports::atlas;

namespace {

AtlasMap map_named(const std::string& name) {
    for (const AtlasMap& map : atlas_maps()) {
        if (map.name == name) return map;
    }
    throw std::out_of_range(name);
}

CellResult result_of(const AtlasMap& map, const std::string& x, const std::string& y) {
    return run_cell(cell_at(map, x, y), [] {});
}

bool has_look(std::string_view outcome) {
    return std::ranges::find(outcome_looks, outcome, &OutcomeLook::outcome) != outcome_looks.end();
}

bool stands(const CellResult& result) {
    return result.outcome == "rest" || result.outcome == "creep" || result.outcome == "jitter";
}

}  // namespace

TEST_CASE("every cell of the atlas is a run that the program takes, and no two are the same") {
    std::set<std::string> commands;
    std::size_t count = 0;
    for (const AtlasMap& map : atlas_maps()) {
        for (const AtlasAxis* axis : {&map.x, &map.y}) {
            REQUIRE(axis->values.size() >= 5);
            CHECK(std::is_sorted(axis->values.begin(), axis->values.end(),
                                 [&](const auto& a, const auto& b) { return axis->shown(a) < axis->shown(b); }));
            if (axis->logarithmic) CHECK(axis->shown(axis->values.front()) > 0.0);
        }
        for (const AtlasCell& cell : cells_of(map)) {
            INFO(cell.command());
            OptionTexts options = map.common;
            options.emplace_back(map.x.option, cell.x);
            options.emplace_back(map.y.option, cell.y);
            CHECK_NOTHROW(run_of(map.scene, options));
            CHECK(cell.command().find(',') == std::string::npos);
            commands.insert(cell.command());
            ++count;
        }
    }
    CHECK(commands.size() == count);
}

TEST_CASE("an outcome of every kind has a look of its own") {
    std::set<int> colours;
    for (const OutcomeLook& look : outcome_looks) colours.insert(look.colour);
    CHECK(colours.size() == outcome_looks.size());
    for (const Outcome outcome : {Outcome::fly, Outcome::tunnel, Outcome::torn, Outcome::fall, Outcome::moving,
                                  Outcome::creep, Outcome::jitter, Outcome::rest}) {
        CHECK(has_look(name_of(outcome)));
    }
    CHECK(has_look(non_finite));
}

TEST_CASE("a heavy cube that stands with some iterations stands with more, and not with a tenth of its ratio") {
    const AtlasMap map = map_named("mass_ratio_iterations");
    for (const std::string ratio : {"1", "10", "100", "1000"}) {
        bool stood = false;
        for (const std::string iterations : {"1", "10", "100", "500"}) {
            const CellResult result = result_of(map, ratio, iterations);
            INFO(ratio << " times heavier, " << iterations << " iterations: " << result.outcome);
            const double theory = map.theory->y(std::stod(ratio));
            if (stood) CHECK(stands(result));
            if (std::stod(iterations) >= theory) CHECK(result.outcome == "rest");
            if (std::stod(iterations) <= 0.1 * theory) CHECK(!stands(result));
            stood = stands(result);
        }
    }
}

TEST_CASE("the persistent push throws the stack up at the closed form's speed, the single-frame push not at all") {
    const AtlasMap persistent = map_named("overlap_beta_persistent");
    const AtlasMap single_frame = map_named("overlap_beta_single_frame");
    for (const std::string gap : {"-0.05", "-0.2", "-1.2"}) {
        for (const std::string beta : {"0.1", "0.5", "1"}) {
            INFO("gap " << gap << ", beta " << beta);
            const CellResult thrown = result_of(persistent, gap, beta);
            // Five contacts, each less the slop of 0.2 % of 2.4 m.
            const double speed = 5.0 * std::stod(beta) * (-std::stod(gap) - 0.0048) * 60.0;
            CHECK(thrown.value == Approx(speed).epsilon(1e-6));
            if (std::stod(beta) > 1.1 * persistent.theory->y(-std::stod(gap))) CHECK(thrown.outcome == "fly");
            const CellResult moved = result_of(single_frame, gap, beta);
            CHECK(moved.value < 1e-3);  // m/s; 1.7e-4 is the largest
            CHECK(stands(moved));
        }
    }
}

TEST_CASE("bars under tension hold up to the step that resolves their vibration, with substeps at any") {
    const AtlasMap plain = map_named("tension_step_plain");
    const AtlasMap divided = map_named("tension_step_substeps");
    for (const std::string mass : {"30", "300", "3000"}) {
        for (const std::string dt : {"1/15", "1/60", "1/240"}) {
            INFO("end " << mass << " kg, step " << dt << " s");
            const double share = plain.y.shown(dt) / plain.theory->y(std::stod(mass));
            const CellResult result = result_of(plain, mass, dt);
            if (share > 1.3) CHECK(result.value > 1.0);
            if (share < 0.8) CHECK(result.value < 2e-3);
            if (dt != "1/240") CHECK(result_of(divided, mass, dt).value < 2e-3);
        }
    }
}

TEST_CASE("numbers in cells have two digits") {
    CHECK(short_number(0.0) == "0");
    CHECK(short_number(0.00123) == "0.0012");
    CHECK(short_number(0.31234) == "0.31");
    CHECK(short_number(9.96) == "10");
    CHECK(short_number(1234.5) == "1234");
    CHECK(short_number(4.1e-7) == "4e-7");
    CHECK(short_number(2e15) == "2e15");
    CHECK(short_number(3e-13) == "3e-13");
}
