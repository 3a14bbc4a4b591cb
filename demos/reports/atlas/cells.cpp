#include "demos/reports/atlas/cells.h"

#include "demos/reports/atlas/outcomes.h"
#include "demos/reports/pieces/replay_run.h"
#include "demos/reports/study.h"
#include "demos/runs/summary.h"
#include "demos/text/errors.h"

#include <limits>

namespace pushfactor::demos::reports::atlas {

namespace {

OptionTexts options_of(const AtlasCell& cell) {
    OptionTexts options = cell.map->common;
    options.emplace_back(cell.map->x.option, cell.x);
    options.emplace_back(cell.map->y.option, cell.y);
    return options;
}

// NaN if the summary has no such number, as a drift after 10 s in a shorter run.
double number_of_summary(const std::string& summary, const std::string& name) {
    const Json json = Json::parse(summary);
    if (!json.contains(name) || !json[name].is_number()) return std::numeric_limits<double>::quiet_NaN();
    return json[name].get<double>();
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

CellResult run_cell(const AtlasCell& cell, const std::function<void()>& check) {
    const Choices choices = run_of(cell.map->scene, options_of(cell));
    Simulation run(choices);
    Measurements measurements(run);
    const bool finite = play_to_end(run, check, measurements);
    const AtlasMeasure& measure = cell.map->measure;
    const double value = measure.value ? (measurements.*measure.value)()
                                       : number_of_summary(summary_text(choices, run, measurements), measure.key);
    return {std::string(finite ? name_of(measurements.outcome()) : non_finite), value};
}

std::string key_of(const AtlasCell& cell) {
    return "atlas: " + cell.map->measure.key + " of " + run_key(cell.map->scene, options_of(cell));
}

Piece piece_of(const AtlasCell& cell) {
    return {key_of(cell), [cell](const std::function<void()>& check) {
                const CellResult result = run_cell(cell, check);
                return Json{{"outcome", result.outcome}, {"value", json_number(result.value)}};
            }};
}

CellResult result_in(const Json& json) {
    return {json.at("outcome").get<std::string>(), number_in(json.at("value"))};
}

std::string replay_key_of(const AtlasCell& cell) {
    return "atlas: replay of " + run_key(cell.map->scene, options_of(cell));
}

Piece replay_piece_of(const AtlasCell& cell) {
    return {replay_key_of(cell), [cell](const std::function<void()>& check) {
                return Json(replay_of(cell.map->scene, options_of(cell), check));
            }};
}

}  // namespace pushfactor::demos::reports::atlas
