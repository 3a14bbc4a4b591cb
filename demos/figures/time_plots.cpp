// Not in the paper: motion, energy and forces over time.
#include "demos/figures/figure_output.h"
#include "demos/runs/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace pushfactor::demos::figures {

namespace {

using engine::Body;

// Adds the values of `measure` to the rows of `table`, one per step, which begin with the time.
void follow(const Choices& choices, const std::function<std::vector<double>(const Simulation&)>& measure,
            Table& table) {
    Simulation run(choices);
    for (std::size_t step = 0;; ++step) {
        if (table.rows.size() <= step) table.rows.push_back({run.sample().time});
        for (const double value : measure(run)) table.rows[step].emplace_back(value);
        if (run.sample().step >= whole_steps(choices.settings)) return;
        run.advance();
    }
}

double highest(const Simulation& run) {
    double height = 0.0;
    for (const Body& body : run.scene().world.bodies) height = std::max(height, body.position.y());
    return height;
}

double fastest_upwards(const Simulation& run) {
    double speed = 0.0;
    for (const Body& body : run.scene().world.bodies) speed = std::max(speed, velocity(body).y());
    return speed;
}

// Sum of the normal forces of each pair of neighbours, from the lowest pair up [N].
std::vector<double> forces_between(const Simulation& run) {
    const engine::World& world = run.scene().world;
    std::vector<double> forces(world.bodies.size() - 1, 0.0);
    if (world.rows().empty()) return forces;
    for (const auto& site : run.scene().contacts->sites()) {
        const auto upper = static_cast<std::size_t>(std::max(site.body_a, site.body_b));
        forces[upper - 1] += world.lambda()(static_cast<Eigen::Index>(site.normal_row), world.lambda().cols() - 1);
    }
    return forces;
}

}  // namespace

SectionContent intersecting_motion(FigureOutput& output, const Figure& figure) {
    Table table{.columns = {"time_s", "height_none_m", "upward_speed_none_m_per_s", "height_persistent_m",
                            "upward_speed_persistent_m_per_s", "height_single_frame_m",
                            "upward_speed_single_frame_m_per_s"},
                .rows = {}};
    std::vector<double> most;
    for (const char* const push : {"none", "persistent", "single-frame"}) {
        most.push_back(0.0);
        follow(
            run_of("intersecting-stack", {{"preset", "paper"}, {"push", push}, {"seconds", "6"}}),
            [&](const Simulation& run) {
                most.back() = std::max(most.back(), highest(run));
                return std::vector<double>{highest(run), fastest_upwards(run)};
            },
            table);
    }
    const std::string caption = fmt::format(
        "Height of the topmost centre and the largest stored upward velocity of the intersecting stack (preset "
        "paper). It reaches {:.1f} m without a push (the cubes stay inside each other), {:.1f} m with a persistent "
        "one and {:.1f} m with a single-frame push; 10.8 m is the height at rest.",
        most[0], most[1], most[2]);
    return output.plot(
        figure, table, 1.6,
        {.caption = caption,
         .commands = {command_text("run", "intersecting-stack",
                                   {{"preset", "paper"}, {"push", "persistent"}, {"trajectory", "motion.csv"}})}});
}

SectionContent pendulum_energy(FigureOutput& output, const Figure& figure) {
    Table table{.columns = {"time_s", "persistent_1", "persistent_0.2", "single_frame_1"}, .rows = {}};
    std::vector<double> left;
    for (const auto& [push, beta] :
         {std::pair{"persistent", "1"}, std::pair{"persistent", "0.2"}, std::pair{"single-frame", "1"}}) {
        double start = 0.0, kinetic = 0.0, potential = 0.0, lowest = 0.0;
        follow(
            run_of("pendulum-wave",
                   {{"count", "1"}, {"distance-push", push}, {"distance-beta", beta}, {"seconds", "120"}}),
            [&](const Simulation& run) {
                // Momenta are half a step before positions, so the kinetic energies of two steps are averaged
                // around the potential energy between them; the first value is the start, at rest.
                const Sample& now = run.sample();
                const double hung = run.scene().gravity.norm() * 3.2;  // the hook has zero potential energy
                if (now.step == 0) {
                    const engine::Distance& bar = run.scene().distances->distances().front();
                    lowest = hung - run.scene().gravity.norm() * (bar.length + 0.1);
                    start = now.potential_energy - lowest;
                }
                const double energy =
                    now.step == 0 ? start : potential + 0.5 * (kinetic + now.kinetic_energy) - lowest;
                kinetic = now.kinetic_energy;
                potential = now.potential_energy;
                return std::vector<double>{energy / start};
            },
            table);
        left.push_back(table.rows.back().back().number());
    }
    const std::string caption = fmt::format(
        "Energy of a pendulum's swing over two minutes at 60 steps per second, as a share of what it had at the "
        "start. For distances the persistent push is the right one: after 120 s {:.1f} % is left with beta 1, "
        "{:.1f} % with beta 0.2; a single-frame push takes the correction out of the velocity each step, and "
        "{:.1f} % is left.",
        100.0 * left[0], 100.0 * left[1], 100.0 * left[2]);
    return output.plot(
        figure, table, 1.9,
        {.caption = caption,
         .commands = {command_text("run", "pendulum-wave",
                                   {{"count", "1"}, {"distance-push", "single-frame"}, {"seconds", "120"}})}});
}

SectionContent stack_forces(FigureOutput& output, const Figure& figure) {
    Table table{.columns = {"time_s"}, .rows = {}};
    const Choices choices = run_of("stack", {{"seconds", "10"}});
    for (std::size_t i = 1; i < choices.description.bodies.size(); ++i) {
        table.columns.push_back(fmt::format("below_cube_{}_n", i));
    }
    std::vector<double> last;
    follow(
        choices, [&](const Simulation& run) { return last = forces_between(run); }, table);
    const std::string caption = fmt::format(
        "Contact forces of the stack, summed over the points below each cube, in the first two seconds; default "
        "settings. After 10 s they are {:.4f}, {:.4f}, {:.4f}, {:.4f} and {:.4f} N: what each pair has to carry is "
        "60, 48, 36, 24 and 12 N.",
        last[0], last[1], last[2], last[3], last[4]);
    return output.plot(figure, table, 1.9,
                       {.caption = caption, .commands = {command_text("run", "stack", {{"rows", "rows.csv"}})}});
}

}  // namespace pushfactor::demos::figures
