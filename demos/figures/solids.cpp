// Not in the paper: the wave along a row of dominoes, and how fast regular solids lose their energy.
#include "demos/figures/figure_output.h"
#include "demos/runs/simulation.h"
#include "demos/scenes/named/platonic.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pushfactor::demos::figures {

namespace {

using engine::Body;

// Dominoes of one curve.
struct Row {
    double height;  // m
    const char* friction;
};
constexpr std::array dominoes_shown{Row{0.048, "0.3"}, Row{0.192, "0.3"}, Row{0.048, "0.1"}, Row{0.048, "0.6"}};
constexpr std::array spacings{0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
constexpr int dominoes_of_a_row = 40;
constexpr std::size_t first_timed = 16, last_timed = 34;
constexpr double leaning = 0.05;   // rad, of a domino that the wave has reached
constexpr double stronger = 3.0;   // push than that of the scene: narrow rows need it to start
constexpr double longest = 120.0;  // in sqrt(h / g): a wave that takes longer has died

// Speed of the wave between two dominoes in sqrt(g h); NaN if it does not reach the second one.
double wave_speed(const Row& row, double spacing) {
    Choices choices = run_of("dominoes", {{"count", std::to_string(dominoes_of_a_row)},
                                          {"height", fmt::format("{}", row.height)},
                                          {"spacing", fmt::format("{}", spacing)},
                                          {"friction", row.friction},
                                          {"dt", "1/480"},
                                          {"substeps", "1"}});
    BodyDescription& first = choices.description.bodies[1];
    first.velocity *= stronger;
    first.angular_velocity *= stronger;
    Simulation run(choices);
    const std::vector<Body>& bodies = run.scene().world.bodies;
    const double gravity = run.scene().gravity.norm();
    const double way = bodies[last_timed].position.x() - bodies[first_timed].position.x();
    std::array<double, 2> reached{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Body& domino = bodies[i == 0 ? first_timed : last_timed];
        while ((domino.orientation * engine::Vector3::UnitY()).y() > std::cos(leaning)) {
            if (run.sample().time > longest * std::sqrt(row.height / gravity)) return std::nan("");
            run.advance();
        }
        reached[i] = run.sample().time;
    }
    return way / (reached[1] - reached[0]) / std::sqrt(gravity * row.height);
}

}  // namespace

SectionContent domino_speed(FigureOutput& output, const Figure& figure) {
    Table table{.columns = {"spacing_heights"}, .rows = {}};
    for (const Row& row : dominoes_shown) {
        table.columns.push_back(fmt::format("speed_{:g}_mm_friction_{}", 1e3 * row.height, row.friction));
    }
    double apart = 0.0;
    for (const double spacing : spacings) {
        auto& speeds = table.rows.emplace_back();
        speeds.push_back(spacing);
        for (const Row& row : dominoes_shown) speeds.push_back(wave_speed(row, spacing));
        apart = std::max(apart, std::abs(speeds[2].number() / speeds[1].number() - 1.0));
    }
    const std::string caption = fmt::format(
        "Speed of the wave along a row of {} dominoes against the gap between them, measured from the {}th to the "
        "{}th. Both in units of the height h: speeds of rows of one friction and different sizes fall on one "
        "curve, to {:.2g} % at most, because only the square root of g h has the unit of a speed.",
        dominoes_of_a_row, first_timed, last_timed, 100.0 * apart);
    return output.plot(
        figure, table, 1.6,
        {.caption = caption, .commands = {"pushfactor render dominoes --spacing 0.3 --friction 0.3 --seconds 2"}});
}

SectionContent platonic_energy(FigureOutput& output, const Figure& figure) {
    const auto& solids = scenes::regular_solids();
    Table table{.columns = {"time_s"}, .rows = {}};
    for (const scenes::RegularSolid& solid : solids) table.columns.push_back(std::string(solid.name) + "_j");
    Simulation run(run_of("platonic", {{"seconds", "6"}}));
    std::vector<std::vector<std::size_t>> members(solids.size());  // bodies of each kind
    std::size_t count = 0;
    for (std::size_t kind = 0; kind < solids.size(); ++kind) {
        for (std::size_t i = 0; i < run.scene().bodies.size(); ++i) {
            if (run.scene().bodies[i].name.starts_with(solids[kind].name)) members[kind].push_back(i);
        }
        count += members[kind].size();
    }
    std::vector<double> quiet(solids.size(), 0.0);  // s, when the mean last was above a thousandth of a joule
    while (run.sample().step < whole_steps(run.settings())) {
        run.advance();
        auto& row = table.rows.emplace_back();
        row.push_back(run.sample().time);
        for (std::size_t kind = 0; kind < solids.size(); ++kind) {
            double energy = 0.0;
            for (const std::size_t i : members[kind]) {
                energy += engine::kinetic_energy(std::span(&run.scene().world.bodies[i], 1)) /
                          static_cast<double>(members[kind].size());
            }
            row.push_back(energy);
            if (energy > 1e-3) quiet[kind] = run.sample().time;
        }
    }
    std::string caption = fmt::format(
        "Kinetic energy per body of {} regular solids of 1 kg and one volume, poured into the funnel. It is "
        "above 1 mJ until",
        count);
    for (std::size_t kind = 0; kind < solids.size(); ++kind)
        caption += fmt::format("{} {:.1f} s for the {}", kind == 0 ? "" : ",", quiet[kind], solids[kind].name);
    return output.plot(figure, table, 1.6,
                       {.caption = caption + ".", .commands = {"pushfactor render platonic --seconds 6"}});
}

}  // namespace pushfactor::demos::figures
