// atlas.csv: the cells that were run. It grows by a line a cell, so that what was interrupted can go on.
#pragma once

#include "demos/reports/atlas/cells.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::atlas {

class AtlasFile {
  public:
    // Takes over what the file holds, or begins a new one; a last line that was not finished is dropped. `atlas`
    // has all cells that may be in the file and must outlive this. Throws UsageError, and leaves the file as it is,
    // when something in it is no line that this version writes for one of these cells; OutputError when it cannot
    // be read or written.
    AtlasFile(std::filesystem::path path, const std::vector<AtlasMap>& atlas);

    // Null when the cell was not run yet.
    const CellResult* find(const AtlasCell& cell) const;

    // Adds a line, which is in the file when this returns.
    void add(const AtlasCell& cell, const CellResult& result);

    // Writes the lines anew in the order of the atlas. Nothing may be added afterwards.
    void sort();

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    void take_over(const std::string& text);
    void take_line(const std::string& line, long number);
    [[noreturn]] void refuse(const std::string& what) const;
    [[noreturn]] void fail(int error) const;

    std::filesystem::path path_;
    std::vector<AtlasCell> cells_;               // in the order of the atlas
    std::map<std::string, CellResult> results_;  // by what their lines begin with
    std::unique_ptr<std::FILE, Close> file_;     // open to add lines
};

}  // namespace pushfactor::demos::reports::atlas
