// The stability atlas, maps of the outcomes of runs over two of their parameters: atlas.csv, and the maps that are
// complete. A piece is a cell, so that the full atlas, the quick one and a part share what they have in common.
#include "demos/base/platform/version.h"
#include "demos/base/text/suggest.h"
#include "demos/figures/plot.h"
#include "demos/pages/short_numbers.h"
#include "demos/reports/atlas/atlas.h"
#include "demos/runs/summary.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace pushfactor::demos::reports {

namespace {

using namespace atlas;

std::string key_of(const std::string& what, const AtlasCell& cell) {
    return fmt::format("atlas: {} of {}", what, run_key(cell.scene, cell.options));
}

Piece piece_of(const AtlasCell& cell) {
    return {key_of(cell.measure, cell), [cell](const StopCheck& check) {
                const auto [outcome, value] = run_cell(cell, check);
                return Json{{"outcome", outcome}, {"value", json_number(value)}};
            }};
}

// A page that plays the run of the cell, as a piece whose result is its text; and the name of its file.
Piece replay_piece_of(const AtlasCell& cell) {
    return {key_of("replay", cell),
            [cell](const StopCheck& check) { return Json(replay_of(cell.scene, cell.options, check)); }};
}

std::string replay_file(const AtlasMap& map, const AtlasCell& cell) {
    std::string name = fmt::format("{}_{}_{}_{}", map.x.option, cell.x, map.y.option, cell.y);
    std::ranges::replace(name, '/', '-');
    return "cells/" + name + ".html";
}

// All maps of the request, whether asked for by --only or not.
std::vector<AtlasMap> maps_of(const StudyRequest& request) {
    return request.grid ? std::vector{grid_map(*request.grid)} : atlas_maps(request.quick);
}

Pieces atlas_pieces(const StudyRequest& request) {
    Pieces pieces;
    for (const AtlasMap& map : maps_of(request)) {
        if (!request.grid && !request.wants(map.name)) continue;
        for (const AtlasCell& cell : cells_of(map)) pieces.push_back(piece_of(cell));
        if (!request.grid) continue;
        for (const AtlasCell& cell : cells_with_replay(map, *request.grid)) pieces.push_back(replay_piece_of(cell));
    }
    return pieces;
}

void add_replays(const AtlasMap& map, StudyRun& run, SectionContent& plate) {
    for (const AtlasCell& cell : cells_with_replay(map, *run.request().grid)) {
        run.write(replay_file(map, cell), run.result(replay_piece_of(cell).key).get<std::string>());
        plate.replays.push_back(replay_file(map, cell));
    }
}

// Edges of the cells of an axis, halfway between their numbers: one more than there are cells.
std::vector<double> edges_of(const AtlasAxis& axis) {
    std::vector<double> places;
    for (const std::string& value : axis.values)
        places.push_back(axis.logarithmic ? std::log(axis.shown(value)) : axis.shown(value));
    std::vector<double> edges{places[0] - 0.5 * (places[1] - places[0])};
    for (std::size_t i = 1; i < places.size(); ++i) edges.push_back(0.5 * (places[i - 1] + places[i]));
    const std::size_t last = places.size() - 1;
    edges.push_back(places[last] + 0.5 * (places[last] - places[last - 1]));
    if (axis.logarithmic)
        std::ranges::transform(edges, edges.begin(), [](double place) { return std::exp(place); });
    return edges;
}

// For `set xtics (...)`: all values, or about as many as have room.
std::string ticks_of(const AtlasAxis& axis) {
    constexpr std::size_t most = 16;
    const std::size_t every = (axis.values.size() + most - 1) / most;
    std::string text;
    for (std::size_t i = 0; i < axis.values.size(); i += every) {
        const std::string& value = axis.values[i];
        const std::string tick = axis.scale == 1.0 ? value : fmt::format("{:.3g}", axis.shown(value));
        text += fmt::format("{}\"{}\" {}", text.empty() ? "" : ", ", tick, axis.shown(value));
    }
    return text;
}

// Two blocks, the cells and the theory. Never empty, because gnuplot does not count empty blocks.
std::string data_of(const AtlasMap& map, const std::vector<CellResult>& results, const std::vector<double>& xs,
                    const std::vector<double>& ys) {
    std::string text = "# x,y,x_low,x_high,y_low,y_high,colour,number,ink\n";
    const std::size_t width = map.x.values.size();
    const bool has_room = width <= 16 && map.y.values.size() <= 24;  // for numbers
    for (std::size_t i = 0; i < results.size(); ++i) {
        const std::size_t column = i % width, row = i / width;
        const OutcomeLook& look = *std::ranges::find(outcome_looks, results[i].outcome, &OutcomeLook::outcome);
        text += fmt::format(
            "{},{},{},{},{},{},{},{},{}\n", map.x.shown(map.x.values[column]), map.y.shown(map.y.values[row]),
            xs[column], xs[column + 1], ys[row], ys[row + 1], look.colour,
            has_room && !std::isnan(results[i].value) ? short_number(results[i].value) : " ", look.ink);
    }
    text += "\n\n# theory: x,y\n";
    constexpr int points = 400;
    for (int i = 0; i <= points; ++i) {
        const double share = static_cast<double>(i) / points;
        const double x = map.x.logarithmic ? xs.front() * std::pow(xs.back() / xs.front(), share)
                                           : xs.front() + share * (xs.back() - xs.front());
        const double y = map.theory ? map.theory->y(x) : std::nan("");
        text += y >= ys.front() && y <= ys.back() ? fmt::format("{},{}\n", x, y) : "nan,nan\n";
    }
    return text;
}

// The map as a picture, one colour per outcome and the measured number in each cell: writes NAME.dat and, where
// gnuplot is installed, draws it as NAME.png and NAME.svg. `results` are those of cells_of(map), in that order.
Section atlas_section(const AtlasMap& map, const std::vector<CellResult>& results,
                      const std::filesystem::path& folder) {
    const std::string command = cell_at(map, "X", "Y").command();  // of all cells, with X and Y for the values
    Section section{map.name, map.title};
    section.content.caption = fmt::format("{} The numbers: {} of the summary.", map.caption, map.measure.key);
    section.content.commands = {command};
    const std::vector<double> xs = edges_of(map.x), ys = edges_of(map.y);
    std::string words, colours;  // of the outcomes on the map, for gnuplot's word()
    for (const OutcomeLook& look : outcome_looks) {
        if (std::ranges::find(results, look.outcome, &CellResult::outcome) == results.end()) continue;
        words += fmt::format("\"{}\" ", look.outcome == name_of(Outcome::moving) ? map.moving : look.words);
        colours += fmt::format("#{:06x} ", look.colour);
    }
    const Plot plot{.script = "atlas",
                    .data = map.name + ".dat",
                    .name = map.name,
                    .aspect = 1.5,
                    .variables = {{"heading", map.title},
                                  {"x_axis", map.x.label},
                                  {"y_axis", map.y.label},
                                  {"x_ticks", ticks_of(map.x)},
                                  {"y_ticks", ticks_of(map.y)},
                                  {"x_low", xs.front()},
                                  {"x_high", xs.back()},
                                  {"y_low", ys.front()},
                                  {"y_high", ys.back()},
                                  {"x_logarithmic", map.x.logarithmic ? 1.0 : 0.0},
                                  {"y_logarithmic", map.y.logarithmic ? 1.0 : 0.0},
                                  {"outcomes", words},
                                  {"colours", colours},
                                  {"number_words", map.measure.words},
                                  {"theory", map.theory ? map.theory->label : ""},
                                  {"command", command}}};
    add_plot(plot, data_of(map, results, xs, ys), folder, section.content);
    return section;
}

void make_atlas(StudyRun& run) {
    Table table{{"map", "x_name", "x", "y_name", "y", "outcome", "measure", "value", "command"}};
    for (const AtlasMap& map : maps_of(run.request())) {
        std::vector<CellResult> results;
        Table lines;
        for (const AtlasCell& cell : cells_of(map)) {
            const auto found = run.find(piece_of(cell).key);
            if (!found) break;
            const auto& [outcome, value] =
                results.emplace_back(CellResult{found->at("outcome"), number_in(found->at("value"))});
            lines.rows.push_back({map.name, map.x.option, cell.x, map.y.option, cell.y, outcome, map.measure.key,
                                  std::isnan(value) ? Cell() : Cell(value), cell.command()});
        }
        if (results.size() < map.x.values.size() * map.y.values.size()) continue;
        table.rows.insert(table.rows.end(), lines.rows.begin(), lines.rows.end());
        run.sections.push_back(atlas_section(map, results, run.folder()));
        if (run.request().grid) add_replays(map, run, run.sections.back().content);
    }
    run.write("atlas.csv", fmt::format("# pushfactor {}: stability atlas\n{}", version_number(), csv_text(table)));
    run.write_page(
        fmt::format("Outcomes of runs over two of their parameters: a cell is a run, its colour the outcome that "
                    "the run's summary names, judged over the last second. White dashed lines are theoretical "
                    "limits. atlas.csv has the command that reproduces each cell.{}",
                    run.quick() ? " This is the quick atlas: three values per axis." : ""));
}

}  // namespace

std::string atlas::short_number(double value) {
    if (value == 0.0) return "0";
    const double size = std::abs(value);
    if (size >= 1e-3 && size < 9.95) return fmt::format("{:.2g}", value);
    if (size >= 9.95 && size < 9999.5) return fmt::format("{:.0f}", value);
    return short_cell(fmt::format("{:.0e}", value));
}

AtlasCell atlas::cell_at(const AtlasMap& map, const std::string& x, const std::string& y) {
    AtlasCell cell{map.scene, x, y, map.common, map.measure.key};
    cell.options.insert(cell.options.end(), {{map.x.option, x}, {map.y.option, y}});
    return cell;
}

std::vector<AtlasCell> atlas::cells_of(const AtlasMap& map) {
    std::vector<AtlasCell> cells;
    for (const std::string& y : map.y.values) {
        for (const std::string& x : map.x.values) cells.push_back(cell_at(map, x, y));
    }
    return cells;
}

CellResult atlas::run_cell(const AtlasCell& cell, const StopCheck& check) {
    const Choices choices = run_of(cell.scene, cell.options);
    Simulation run(choices);
    Measurements measurements(run);
    const bool finite = play_to_end(run, check, measurements);
    // The summary may have no such number, as a drift after 10 s in a shorter run.
    const Json summary = summary_of(choices, run, measurements);
    const auto number = summary.find(cell.measure);
    const bool has_number = number != summary.end() && number->is_number();
    return {std::string(finite ? name_of(measurements.outcome()) : non_finite),
            has_number ? number->get<double>() : std::numeric_limits<double>::quiet_NaN()};
}

Study atlas_study() {
    return {.name = "atlas",
            .title = "stability atlas",
            .parts = [] { return names_of(atlas_maps()); },
            .make = make_atlas,
            .pieces = atlas_pieces};
}

}  // namespace pushfactor::demos::reports
