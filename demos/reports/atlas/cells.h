// The cells of an atlas: one run each, judged as its summary judges it.
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

// Row by row from below.
std::vector<AtlasCell> cells_of(const AtlasMap& map);

// "pushfactor run ..." that makes the same run.
std::string command_of(const AtlasCell& cell);

struct CellResult {
    std::string outcome;  // as in a summary, or "non-finite"
    double value = 0.0;   // of the map's measure, up to where the run became non-finite
};

// Nothing when it was stopped. Throws what errors.h names, but not NonFiniteError.
std::optional<CellResult> run_cell(const AtlasCell& cell, const std::stop_token& stop);

// Runs the cells on all cores, from the first on. `finished` is called in the calling thread as soon as a cell is
// done, in no order that could be told beforehand; `check` is called often. What they or a run throw ends the work:
// runs that are under way are dropped.
void run_cells(std::span<const AtlasCell> cells,
               const std::function<void(const AtlasCell&, const CellResult&)>& finished,
               const std::function<void()>& check);

}  // namespace pushfactor::demos::reports::atlas
