// The report on cost: what each scene is made of, what a step of it does, and what leaving things out saves.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pushfactor::demos::reports {

struct CostRequest {
    std::filesystem::path folder;
    bool quick = false;              // small scenes, timed three times instead of five
    std::vector<std::string> parts;  // names of cost_parts(); all when empty
};

// The scenes of the catalogue, and "side-by-side" for scenes in one world.
std::vector<std::string> cost_parts();

// Writes cost.csv (two lines per scene: as it is, and with everything constructed), side_by_side.csv (scenes in one
// world against the sum of each alone), plots, index.html, everything/NAME.json, the scenes with everything, and
// side-by-side/NAME.json. The tables are whole after each scene, so an interrupted report
// keeps what it had. Throws what errors.h names.
void report_cost(const CostRequest& request);

}  // namespace pushfactor::demos::reports
