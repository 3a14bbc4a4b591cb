// The cells of an atlas: one run each, with the outcome of its summary.
#pragma once

#include "demos/reports/atlas/maps.h"

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
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
    double value = 0.0;   // of the map's measure, up to the last finite step
};

// None if it was stopped. Throws the exceptions of errors.h except NonFiniteError.
std::optional<CellResult> run_cell(const AtlasCell& cell, const std::stop_token& stop);

// Runs the cells on all cores. `finished` is called in the calling thread as soon as a cell is done, in unspecified
// order; `check` is called often. An exception of theirs or of a run stops all: runs in progress are dropped.
void run_cells(std::span<const AtlasCell> cells,
               const std::function<void(const AtlasCell&, const CellResult&)>& finished,
               const std::function<void()>& check);

}  // namespace pushfactor::demos::reports::atlas
