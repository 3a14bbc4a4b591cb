// The tosses as this engine computes them: the law of contact that fits every other toss, and how far it goes on
// the others; beside other engines where their results are given.
#include "demos/base/platform/assets.h"
#include "demos/base/text/csv.h"
#include "demos/base/text/median.h"
#include "demos/base/text/numbers.h"
#include "demos/figures/plot.h"
#include "demos/reports/reality/sections.h"
#include "demos/scenes/motions/measured_motion.h"
#include "demos/scenes/scene_file.h"

#include <fmt/format.h>

#include <numeric>

namespace pushfactor::demos::reports::reality {

namespace {

using engine::Vector3;

SceneDescription scene_from(const Restart& start, const Law& law) {
    return one_on_another("toss", {.name = "board", .shape = PlaneShape{}, .position = Vector3(0, law.board, 0)},
                          {.name = "cube",
                           .shape = BoxShape{Vector3::Constant(edge)},
                           .mass = mass,
                           .moments = Vector3::Constant(moment_of_inertia),
                           .position = start.pose.position,
                           .orientation = start.pose.orientation,
                           .velocity = start.velocity,
                           .angular_velocity = start.angular_velocity,
                           .colour = "blue"},
                          law);
}

// What tests/compare writes of another engine: its results, and its mean error of position over the time since the
// first contact.
struct OtherEngine {
    std::string name;
    std::vector<Result> results;
    std::vector<std::pair<double, double>> over_time;  // s, edges
};

std::vector<OtherEngine> read_others(const std::optional<std::filesystem::path>& file) {
    std::vector<OtherEngine> engines;
    if (!file) return engines;
    for (const auto& cells : read_csv("--beside", *file, {"engine", "what", "at_s", "value", "error"})) {
        if (engines.empty() || engines.back().name != cells[0]) engines.push_back({cells[0], {}, {}});
        const auto at = parse_number(cells[2]), value = parse_number(cells[3]);
        if (!value) throw UsageError("--beside {}: value {}: must be a number", file->string(), cells[3]);
        if (at) {
            engines.back().over_time.emplace_back(*at, *value);
        } else {
            engines.back().results.push_back({cells[1], *value, parse_number(cells[4])});
        }
    }
    return engines;
}

// The error to two digits, the value as far.
std::string text_of(const Result& result) {
    if (!result.error || *result.error <= 0.0) return fmt::format("{:.4g}", result.value);
    const int digits = std::max(0, 1 - static_cast<int>(std::floor(std::log10(*result.error))));
    return fmt::format("{:.{}f} ± {:.{}f}", result.value, digits, *result.error, digits);
}

// A line for each of our results, a column for each engine.
TextTable page_table(const std::vector<Result>& ours, const std::vector<OtherEngine>& others) {
    TextTable table{{"", "Pushfactor"}};
    for (const OtherEngine& engine : others) table.front().push_back(engine.name);
    for (const Result& result : ours) {
        std::vector<std::string> line{result.what, text_of(result)};
        for (const OtherEngine& engine : others) {
            const auto found = std::ranges::find(engine.results, result.what, &Result::what);
            line.push_back(found == engine.results.end() ? "" : text_of(*found));
        }
        table.push_back(line);
    }
    return table;
}

// One block of lines for each engine, for gnuplot.
std::string blocks_of(const std::vector<OtherEngine>& others) {
    std::string text;
    for (const OtherEngine& engine : others) {
        // gnuplot ends a title at a comma.
        std::string title = engine.name;
        std::ranges::replace(title, ',', ';');
        text += fmt::format("\n\n\"{}\"\n", title);
        for (const auto& [time, error] : engine.over_time) text += fmt::format("{},{}\n", time, error);
    }
    return text;
}

// The best, the median and the worst toss.
void add_replays(StudyRun& run, const Tosses& tosses, const Judged& judged, const Law& law,
                 SectionContent& content) {
    std::vector<std::size_t> order(tosses.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t t) { return judged.position[t]; });
    for (const auto& [name, t] : {std::pair{"best", order.front()}, std::pair{"median", order[order.size() / 2]},
                                  std::pair{"worst", order.back()}}) {
        const std::string file = fmt::format("tosses/{}.json", name), page = fmt::format("tosses/{}.html", name);
        run.write(file, scene_file_text(scene_of(tosses[t], law)));
        run.write(page, replay_of((run.folder() / file).string(), {}, run.check()));
        content.replays.push_back(page);
    }
}

void add_bounces(StudyRun& run, const std::vector<ErrorsAt>& bounces) {
    Table table{
        {"after_bounce", "tosses", "position_mean_of_edge", "position_error", "angle_mean_deg", "angle_error_deg"}};
    for (const ErrorsAt& errors : bounces) {
        const Mean place = mean_of(errors.position), turn = mean_of(errors.angle);
        table.rows.push_back({errors.at, errors.position.size(), place.value, place.error, turn.value, turn.error});
    }
    run.sections.push_back({"bounces", "Tosses after each bounce",
                            run.tabulated("toss_bounces.csv", table,
                                          "Errors just before the next contact, or at the end: position in edges, "
                                          "with one standard deviation of the mean.")});
}

// The errors of the fitted tosses over friction and restitution.
Table map_of(const LawFit& fit) {
    const LawGrid& grid = fit.grid();
    Table map{{"friction", "restitution", "mean_error_of_edge"}};
    for (std::size_t f = 0; f < grid.frictions.size(); ++f) {
        for (std::size_t r = 0; r < grid.restitutions.size(); ++r) {
            map.rows.push_back({grid.frictions[f], grid.restitutions[r], fit.error({f, r})});
        }
    }
    return map;
}

Table over_time_of(const std::vector<ErrorsAt>& all) {
    Table table{{"time_since_contact_s", "tosses", "position_mean_of_edge", "position_median_of_edge",
                 "angle_mean_deg", "angle_median_deg"}};
    for (const ErrorsAt& errors : all) {
        table.rows.push_back({errors.at, errors.position.size(), mean_of(errors.position).value,
                              median(errors.position), mean_of(errors.angle).value, median(errors.angle)});
    }
    return table;
}

Table list_of(const Tosses& tosses, const Judged& judged, bool quick) {
    Table table{{"toss", "frames", "position_mean_of_edge", "angle_mean_deg", "same_face_on_top"}};
    for (std::size_t t = 0; t < tosses.size(); ++t) {
        table.rows.push_back({1 + t * (quick ? 10 : 2), tosses[t].frames.size(), judged.position[t],
                              judged.angle[t], judged.right[t] ? "yes" : "no"});
    }
    return table;
}

// The spread of the measured height of cubes that lie: what the measurement gives away at least.
Result noise_of(const Tosses& tosses) {
    std::vector<double> heights;
    for (const Toss& toss : tosses) heights.push_back(toss.frames.back().position.y() / edge);
    return {"noise: spread of the measured height at rest, % of an edge",
            100.0 * mean_of(heights).error * std::sqrt(static_cast<double>(heights.size()))};
}

}  // namespace

std::vector<Pose> computed(const Restart& start, const Law& law, std::size_t frames) {
    Settings settings = preset_settings("default");
    settings.dt = {1, frames_per_second};
    settings.threads = 1;
    settings.start_kick = StartKick::on;  // the measured velocity is that of the first frame
    Simulation run(build_scene(scene_from(start, law), settings), settings);
    std::vector<Pose> poses{start.pose};
    while (poses.size() < frames) {
        run.advance();
        const engine::Body& now = run.scene().world.bodies.at(1);
        poses.push_back({now.position, now.orientation});
    }
    return poses;
}

SceneDescription scene_of(const Toss& toss, const Law& law) {
    SceneDescription scene = scene_from(toss.start, law);
    std::vector<PoseLine> measured;
    for (std::size_t i = 0; i < toss.frames.size(); ++i) {
        measured.push_back({static_cast<double>(i) / frames_per_second,
                            {.position = toss.frames[i].position, .orientation = toss.frames[i].orientation}});
    }
    add_measured(scene, 1, measured);
    const Vector3 middle = 0.5 * (toss.frames.front().position + toss.frames.back().position);
    scene.view = {.eye = middle + Vector3(0.35, 0.3, 0.75), .target = middle};
    scene.options = {{"dt", fmt::format("1/{}", frames_per_second)},
                     {"seconds", fmt::format("{}/{}", toss.frames.size() - 1, frames_per_second)},
                     {"start-kick", "on"}};
    return scene;
}

void add_tosses(StudyRun& run) {
    const std::vector<OtherEngine> engines = read_others(run.request().beside);
    const Tosses all = read_tosses(asset_folder("measured"));
    const Tosses fitted = half_of(all, 0, run.quick()), others = half_of(all, 1, run.quick());
    const LawGrid grid = law_grid(fitted, run.quick());
    Pieces pieces;
    for (const double friction : grid.frictions) {
        const std::string key = fmt::format("reality: {} tosses, friction {}, {} restitutions", fitted.size(),
                                            friction, grid.restitutions.size());
        pieces.push_back({key, [&, friction](const StopCheck& check) {
                              return json_numbers(errors_with(computed, fitted, grid, friction, check));
                          }});
    }
    run.gather(pieces);
    std::vector<std::vector<double>> errors;
    for (const Piece& piece : pieces) errors.push_back(numbers_in(run.result(piece.key)));
    const LawFit fit(grid, std::move(errors));
    const Law law = fit.best();
    const Judged judged = judge(computed, others, law);
    std::vector<Result> results = results_of(computed, fit, others, judged);
    const Mean authors = mean_of(judge(computed, others, {0.18, 0.125, law.board}).position);
    results.push_back({"position with the authors' friction 0.18, restitution 0.125", 100.0 * authors.value,
                       100.0 * authors.error});
    results.push_back(noise_of(others));

    const Table map = map_of(fit), over_time = over_time_of(errors_over_time(others, judged, law));
    run.write("toss_fit.csv", map);
    run.write("toss_errors.csv", over_time);
    run.write("tosses.csv", list_of(others, judged, run.quick()));
    Table table{{"what", "value", "error"}};
    for (const Result& result : results) table.rows.push_back({result.what, result.value, result.error});
    run.write("toss_results.csv", table);

    SectionContent content{.files = {"toss_results.csv", "toss_fit.csv", "toss_errors.csv", "tosses.csv"},
                           .table = page_table(results, engines)};
    content.caption = fmt::format(
        "A cube of 0.1048 m and 0.37 kg, tossed onto a board: {} tosses of ContactNets (Pfrommer, Halm and Posa "
        "2020; BSD 3-clause), 148 poses a second. Each is computed from its first pose and velocity, with one law "
        "of contact for all: fitted on {} tosses for the least mean error of position, judged on {} others. Errors "
        "are one standard deviation: of the law over 200 sets drawn again from the fitted tosses, of means over "
        "tosses, of shares after Wilson. In flight the error is that of the measured poses and velocities; "
        "restarts keep chaos out of what contacts add. In the replays the computed cube hides the measured one "
        "(ivory) where they agree.{}",
        all.size(), fitted.size(), others.size(),
        engines.empty() ? ""
                        : " Other engines have the same fit, each its own law; tests/compare reality made them.");
    add_plot({.script = "toss_errors",
              .data = "toss_errors.dat",
              .name = "toss_errors",
              .variables = {{"others", static_cast<double>(engines.size())}}},
             csv_text(over_time) + blocks_of(engines), run.folder(), content);
    add_plot({.script = "toss_map",
              .data = "toss_map.dat",
              .name = "toss_map",
              .variables = {{"best_friction", law.friction}, {"best_restitution", law.restitution}}},
             csv_text(map), run.folder(), content);
    add_replays(run, others, judged, law, content);
    run.sections.push_back({"tosses", "Tosses of a cube", content});
    add_bounces(run, errors_by_bounce(others, judged, law));
}

}  // namespace pushfactor::demos::reports::reality
