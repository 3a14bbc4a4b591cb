#include "demos/reports/atlas/table.h"

#include "demos/platform/version.h"

#include <cmath>

namespace pushfactor::demos::reports::atlas {

Table empty_table() {
    return {{"map", "x_name", "x", "y_name", "y", "outcome", "measure", "value", "command"}};
}

void add_lines(const AtlasMap& map, const std::vector<CellResult>& results, Table& table) {
    const std::vector<AtlasCell> cells = cells_of(map);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto& [outcome, value] = results.at(i);
        table.rows.push_back({map.name, map.x.option, cells[i].x, map.y.option, cells[i].y, outcome,
                              map.measure.key, std::isnan(value) ? Cell() : Cell(value), command_of(cells[i])});
    }
}

std::string file_text(const Table& table) {
    return "# pushfactor " + version_number() + ": stability atlas\n" + csv_text(table);
}

}  // namespace pushfactor::demos::reports::atlas
