// A map of the atlas as a picture: a colour an outcome, and in each cell the measured number.
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

// Two digits that fit into a cell: "0.31", "12", "4e-07" as "4e-7", and "0".
std::string short_number(double value);

}  // namespace pushfactor::demos::reports::atlas
