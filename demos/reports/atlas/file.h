// atlas.csv: the cells that were run. It grows by a line per cell, so that an interrupted report can be resumed.
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
    // Reads an existing file or begins a new one; an incomplete last line is dropped. `atlas` has all cells that
    // may be in the file and must outlive this. Throws UsageError, and leaves the file as it is, for a line that
    // this version does not write for one of these cells; OutputError if it cannot be read or written.
    AtlasFile(std::filesystem::path path, const std::vector<AtlasMap>& atlas);

    // Null if the cell has not been run.
    const CellResult* find(const AtlasCell& cell) const;

    // Adds a line and flushes it.
    void add(const AtlasCell& cell, const CellResult& result);

    // Rewrites the lines in the order of the atlas. Nothing may be added afterwards.
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
    std::map<std::string, CellResult> results_;  // by the start of their lines
    std::unique_ptr<std::FILE, Close> file_;     // open for appending
};

}  // namespace pushfactor::demos::reports::atlas
