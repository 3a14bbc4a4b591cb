// The stability atlas, maps of the outcomes of runs over two of their parameters: atlas.csv, which grows by a line
// per run and is in the order of the atlas at the end, and the maps that are complete. Runs that atlas.csv has
// already are not repeated.
#include "demos/reports/atlas/file.h"
#include "demos/reports/atlas/plot.h"
#include "demos/reports/study.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports {

namespace {

using namespace atlas;

void run_missing(StudyRun& run, AtlasFile& file, const std::vector<AtlasMap>& maps) {
    std::vector<AtlasCell> missing;
    std::size_t total = 0;
    for (const AtlasMap& map : maps) {
        for (const AtlasCell& cell : cells_of(map)) {
            ++total;
            if (!file.find(cell)) missing.push_back(cell);
        }
    }
    run.begin(total, total - missing.size(), "; the same command resumes from there");
    const auto finished = [&](const AtlasCell& cell, const CellResult& result) {
        file.add(cell, result);
        run.count_run();
    };
    run_cells(missing, finished, run.check());
}

// Results of one map; empty if a cell is missing.
std::vector<CellResult> results_of(const AtlasMap& map, const AtlasFile& file) {
    std::vector<CellResult> results;
    for (const AtlasCell& cell : cells_of(map)) {
        const CellResult* result = file.find(cell);
        if (!result) return {};
        results.push_back(*result);
    }
    return results;
}

void make_atlas(StudyRun& run) {
    const std::vector<AtlasMap> all = atlas_maps();
    std::vector<AtlasMap> shown = all;
    if (run.quick()) std::transform(all.begin(), all.end(), shown.begin(), atlas::quick);
    AtlasFile file(run.folder() / "atlas.csv", all);
    const std::vector<AtlasMap> wanted = run.wanted(shown, &AtlasMap::name);
    run_missing(run, file, wanted);
    file.sort();
    for (const AtlasMap& map : shown) {
        const std::vector<CellResult> results = results_of(map, file);
        if (!results.empty()) run.sections.push_back(atlas_section(map, results, run.folder()));
    }
    run.write_page(fmt::format(
        "Outcomes of runs over two of their parameters: a cell is a run, its colour the outcome that the run's "
        "summary names, judged over the last second. White dashed lines are theoretical limits. "
        "atlas.csv has the command that reproduces each cell.{}",
        run.quick() ? " This is the quick atlas: three values per axis." : ""));
}

}  // namespace

Study atlas_study() {
    std::vector<std::string> parts;
    for (const AtlasMap& map : atlas_maps()) parts.push_back(map.name);
    return {"atlas", "stability atlas", parts, make_atlas};
}

}  // namespace pushfactor::demos::reports
