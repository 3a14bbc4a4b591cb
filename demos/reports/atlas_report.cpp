#include "demos/reports/atlas_report.h"

#include "demos/platform/output_file.h"
#include "demos/platform/progress.h"
#include "demos/reports/atlas/file.h"
#include "demos/reports/atlas/plot.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos::reports {

namespace {

using namespace atlas;

std::filesystem::path in_new_folder(const std::filesystem::path& folder, const char* name) {
    make_folder(folder);
    return folder / name;
}

// One atlas in the making.
class AtlasReport {
  public:
    explicit AtlasReport(const AtlasRequest& request)
        : request_(request),
          atlas_(atlas_maps()),
          shown_(request.quick ? quick_maps() : atlas_),
          path_(in_new_folder(request.folder, "atlas.csv")),
          file_(path_, atlas_) {}

    void make() {
        run_missing();
        file_.sort();
        write_page();
    }

  private:
    std::vector<AtlasMap> quick_maps() const {
        std::vector<AtlasMap> maps;
        for (const AtlasMap& map : atlas_) maps.push_back(quick(map));
        return maps;
    }

    bool wants(const AtlasMap& map) const {
        return request_.maps.empty() ||
               std::find(request_.maps.begin(), request_.maps.end(), map.name) != request_.maps.end();
    }

    void run_missing() {
        std::vector<AtlasCell> missing;
        std::size_t total = 0;
        for (const AtlasMap& map : shown_) {
            if (!wants(map)) continue;
            for (const AtlasCell& cell : cells_of(map)) {
                ++total;
                if (!file_.find(cell)) missing.push_back(cell);
            }
        }
        std::size_t done = total - missing.size();
        ProgressBar bar("report atlas", static_cast<long>(total));
        const auto finished = [&](const AtlasCell& cell, const CellResult& result) {
            file_.add(cell, result);
            bar.show(static_cast<long>(++done));
        };
        const auto check = [&] {
            stop_if_interrupted(fmt::format("{} of {} runs are in {}; the same command goes on from there", done,
                                            total, path_.string()));
        };
        run_cells(missing, finished, check);
    }

    // Of one map; empty when some cell was not run yet.
    std::vector<CellResult> results_of(const AtlasMap& map) const {
        std::vector<CellResult> results;
        for (const AtlasCell& cell : cells_of(map)) {
            const CellResult* result = file_.find(cell);
            if (!result) return {};
            results.push_back(*result);
        }
        return results;
    }

    void write_page() const {
        std::vector<Section> sections;
        for (const AtlasMap& map : shown_) {
            const std::vector<CellResult> results = results_of(map);
            if (!results.empty()) sections.push_back(atlas_section(map, results, request_.folder));
        }
        const std::string opening = fmt::format(
            "How runs end, over two of their parameters: a cell is a run, its colour the outcome that the run's "
            "summary names, judged over the last second. White dashed lines are what theory says beforehand. "
            "atlas.csv has the command that makes each cell again.{}",
            request_.quick ? " This is the quick atlas: three values an axis." : "");
        write_file(request_.folder / "index.html", page_text("Pushfactor: stability atlas", opening, sections));
    }

    AtlasRequest request_;
    std::vector<AtlasMap> atlas_;  // all that there is
    std::vector<AtlasMap> shown_;  // the same maps, with the values that were asked for
    std::filesystem::path path_;
    AtlasFile file_;
};

}  // namespace

std::vector<std::string> atlas_map_names() {
    std::vector<std::string> names;
    for (const AtlasMap& map : atlas_maps()) names.push_back(map.name);
    return names;
}

void report_atlas(const AtlasRequest& request) {
    AtlasReport(request).make();
}

}  // namespace pushfactor::demos::reports
