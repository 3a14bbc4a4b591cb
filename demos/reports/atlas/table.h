// atlas.csv: a line per cell, with the command that reproduces it.
#pragma once

#include "demos/pages/table.h"
#include "demos/reports/atlas/cells.h"

#include <string>
#include <vector>

namespace pushfactor::demos::reports::atlas {

Table empty_table();

// Adds the lines of a map; `results` are those of cells_of(map), in that order.
void add_lines(const AtlasMap& map, const std::vector<CellResult>& results, Table& table);

// The file, with the version in its first line.
std::string file_text(const Table& table);

}  // namespace pushfactor::demos::reports::atlas
