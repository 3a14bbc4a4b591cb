// Maps that people ask for: any two options or parameters of a scene.
#pragma once

#include "demos/reports/atlas/cells.h"
#include "demos/reports/study.h"

#include <vector>

namespace pushfactor::demos::reports::atlas {

// Throws UsageError, one line, for what no run accepts and for a measure that the summary lacks.
AtlasMap grid_map(const GridRequest& request);

// The cells whose replays were asked for.
std::vector<AtlasCell> cells_with_replay(const AtlasMap& map, const GridRequest& request);

// Name of the file of a cell's replay, in the folder of the report.
std::string replay_file(const AtlasCell& cell);

}  // namespace pushfactor::demos::reports::atlas
