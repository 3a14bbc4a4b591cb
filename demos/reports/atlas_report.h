// The stability atlas: maps of the outcomes of runs over two of their parameters.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pushfactor::demos::reports {

struct AtlasRequest {
    std::filesystem::path folder;
    bool quick = false;             // three values an axis
    std::vector<std::string> maps;  // names of atlas_map_names(); all when empty
};

std::vector<std::string> atlas_map_names();

// Writes atlas.csv, which grows by a line a run and is in the order of the atlas at the end; then the maps and
// index.html with all maps that are complete. Runs that atlas.csv has already are not repeated. Throws what
// errors.h names; UsageError for an atlas.csv that this atlas did not write.
void report_atlas(const AtlasRequest& request);

}  // namespace pushfactor::demos::reports
