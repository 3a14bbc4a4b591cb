// The stability atlas, maps of the outcomes of runs over two of their parameters: atlas.csv, and the maps that are
// complete. A piece is a cell, so that the full atlas, the quick one and a part share what they have in common.
#include "demos/platform/output_file.h"
#include "demos/platform/version.h"
#include "demos/reports/atlas/atlas.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace pushfactor::demos::reports {

namespace {

using namespace atlas;

// All maps of the request, whether asked for by --only or not.
std::vector<AtlasMap> maps_of(const StudyRequest& request) {
    return request.grid ? std::vector{grid_map(*request.grid)} : atlas_maps(request.quick);
}

Pieces atlas_pieces(const StudyRequest& request) {
    // Cells refer to their maps.
    const auto maps = std::make_shared<const std::vector<AtlasMap>>(maps_of(request));
    Pieces pieces;
    const auto add = [&](const Piece& piece) {
        pieces.push_back({piece.key, [maps, make = piece.make](const auto& check) { return make(check); }});
    };
    for (const AtlasMap& map : *maps) {
        if (!request.grid && !request.wants(map.name)) continue;
        for (const AtlasCell& cell : cells_of(map)) add(piece_of(cell));
        if (!request.grid) continue;
        for (const AtlasCell& cell : cells_with_replay(map, *request.grid)) add(replay_piece_of(cell));
    }
    return pieces;
}

// Results of one map; empty if a cell is missing.
std::vector<CellResult> results_of(const AtlasMap& map, const StudyRun& run) {
    std::vector<CellResult> results;
    for (const AtlasCell& cell : cells_of(map)) {
        const auto found = run.find(piece_of(cell).key);
        if (!found) return {};
        results.push_back(result_in(*found));
    }
    return results;
}

void add_replays(const AtlasMap& map, StudyRun& run, SectionContent& plate) {
    const std::vector<AtlasCell> cells = cells_with_replay(map, *run.request().grid);
    if (cells.empty()) return;
    make_folder(run.folder() / "cells");
    for (const AtlasCell& cell : cells) {
        run.write(replay_file(cell), run.result(replay_piece_of(cell).key).get<std::string>());
        plate.replays.push_back(replay_file(cell));
    }
}

// A line per cell, with the command that reproduces it.
void add_lines(const AtlasMap& map, const std::vector<CellResult>& results, Table& table) {
    const std::vector<AtlasCell> cells = cells_of(map);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto& [outcome, value] = results.at(i);
        table.rows.push_back({map.name, map.x.option, cells[i].x, map.y.option, cells[i].y, outcome,
                              map.measure.key, std::isnan(value) ? Cell() : Cell(value), command_of(cells[i])});
    }
}

void make_atlas(StudyRun& run) {
    Table table{{"map", "x_name", "x", "y_name", "y", "outcome", "measure", "value", "command"}};
    for (const AtlasMap& map : maps_of(run.request())) {
        const std::vector<CellResult> results = results_of(map, run);
        if (results.empty()) continue;
        add_lines(map, results, table);
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

Study atlas_study() {
    std::vector<std::string> parts;
    for (const AtlasMap& map : atlas_maps()) parts.push_back(map.name);
    return {
        .name = "atlas", .title = "stability atlas", .parts = parts, .make = make_atlas, .pieces = atlas_pieces};
}

}  // namespace pushfactor::demos::reports
