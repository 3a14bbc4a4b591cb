// The cells of an atlas: one run each, with the outcome of its summary.
#include "demos/reports/atlas/atlas.h"
#include "demos/runs/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace pushfactor::demos::reports::atlas {

namespace {

OptionTexts options_of(const AtlasCell& cell) {
    OptionTexts options = cell.map->common;
    options.emplace_back(cell.map->x.option, cell.x);
    options.emplace_back(cell.map->y.option, cell.y);
    return options;
}

std::string key_of(const std::string& what, const AtlasCell& cell) {
    return fmt::format("atlas: {} of {}", what, run_key(cell.map->scene, options_of(cell)));
}

}  // namespace

std::vector<AtlasCell> cells_of(const AtlasMap& map) {
    std::vector<AtlasCell> cells;
    for (const std::string& y : map.y.values) {
        for (const std::string& x : map.x.values) cells.push_back({&map, x, y});
    }
    return cells;
}

std::string command_of(const AtlasCell& cell) {
    return command_text("run", cell.map->scene, options_of(cell));
}

CellResult run_cell(const AtlasCell& cell, const StopCheck& check) {
    const Choices choices = run_of(cell.map->scene, options_of(cell));
    Simulation run(choices);
    Measurements measurements(run);
    const bool finite = play_to_end(run, check, measurements);
    CellResult result{std::string(finite ? name_of(measurements.outcome()) : non_finite)};
    if (const auto value = cell.map->measure.value) {
        result.value = (measurements.*value)();
    } else {
        // The summary may have no such number, as a drift after 10 s in a shorter run.
        const Json json = parse_json(summary_text(choices, run, measurements));
        const auto number = json.find(cell.map->measure.key);
        const bool has_number = number != json.end() && number->is_number();
        result.value = has_number ? number->get<double>() : std::numeric_limits<double>::quiet_NaN();
    }
    return result;
}

Piece piece_of(const AtlasCell& cell) {
    return {key_of(cell.map->measure.key, cell), [cell](const StopCheck& check) {
                const auto [outcome, value] = run_cell(cell, check);
                return Json{{"outcome", outcome}, {"value", json_number(value)}};
            }};
}

CellResult result_in(const Json& json) {
    return {json.at("outcome"), number_in(json.at("value"))};
}

Piece replay_piece_of(const AtlasCell& cell) {
    return {key_of("replay", cell),
            [cell](const StopCheck& check) { return Json(replay_of(cell.map->scene, options_of(cell), check)); }};
}

std::string replay_file(const AtlasCell& cell) {
    std::string name = fmt::format("{}_{}_{}_{}", cell.map->x.option, cell.x, cell.map->y.option, cell.y);
    std::ranges::replace(name, '/', '-');
    return "cells/" + name + ".html";
}

}  // namespace pushfactor::demos::reports::atlas
