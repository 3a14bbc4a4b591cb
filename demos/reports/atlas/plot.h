// A map of the atlas as a picture: one colour per outcome, and the measured number in each cell.
#pragma once

#include "demos/pages/page.h"
#include "demos/reports/atlas/cells.h"

#include <filesystem>
#include <vector>

namespace pushfactor::demos::reports::atlas {

// Writes NAME.dat and, where gnuplot is installed, draws it as NAME.png and NAME.svg. `results` are those of
// cells_of(map), in that order.
Section atlas_section(const AtlasMap& map, const std::vector<CellResult>& results,
                      const std::filesystem::path& folder);

// A number short enough for a cell: "0.31", "12", "4e-7", "0".
std::string short_number(double value);

}  // namespace pushfactor::demos::reports::atlas
