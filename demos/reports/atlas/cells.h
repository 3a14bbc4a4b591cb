// The cells of an atlas: one run each, with the outcome of its summary.
#pragma once

#include "demos/reports/atlas/maps.h"
#include "demos/reports/pieces/piece.h"

#include <functional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::atlas {

struct AtlasCell {
    const AtlasMap* map;
    std::string x, y;  // values of the axes
};

// Cells of a map, row by row from below.
std::vector<AtlasCell> cells_of(const AtlasMap& map);

// "pushfactor run ...", the command that reproduces the cell.
std::string command_of(const AtlasCell& cell);

struct CellResult {
    std::string outcome;  // of the summary, or "non-finite"
    double value = 0.0;  // of the map's measure, up to the last finite step; NaN if the summary has no number there
};

// Throws the exceptions of errors.h except NonFiniteError, and those of `check`, which is called at each step.
CellResult run_cell(const AtlasCell& cell, const std::function<void()>& check);

// The cell as a piece of the report, and its result as it was stored. The map must outlive the piece.
std::string key_of(const AtlasCell& cell);
Piece piece_of(const AtlasCell& cell);
CellResult result_in(const Json& json);

// A page that plays the run of the cell, as a piece; its result is the text of the page.
std::string replay_key_of(const AtlasCell& cell);
Piece replay_piece_of(const AtlasCell& cell);

}  // namespace pushfactor::demos::reports::atlas
