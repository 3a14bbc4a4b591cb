// Files of pieces: one JSON file per piece,
//
//   FOLDER/pieces/VERSION/ab/0123456789abcd.json     ab0123456789abcd: hash of the key
//   {"key": "...", "made_with": "...", "machine": "...", "result": ...}
//
// VERSION is that of the program, so that no version ever uses the pieces of another. A program that was built from
// modified or unknown sources adds a hash of its own file.
#pragma once

#include "demos/reports/pieces/piece.h"

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pushfactor::demos::reports {

struct StoredPiece {
    std::string machine;
    Json result;
};

// All members may be called by several threads and processes at once. They throw OutputError.
class PieceStore {
  public:
    // Pieces are looked for in all folders and written to the first. `machine` is stored with them.
    PieceStore(std::vector<std::filesystem::path> folders, std::string machine)
        : folders_(std::move(folders)), machine_(std::move(machine)) {}

    // A whole piece of this version; none if it is missing or damaged.
    std::optional<StoredPiece> find(const std::string& key) const;

    // Written to a file with a name of its own and renamed: a piece that is there is whole.
    void put(const std::string& key, const Json& result) const;

    // A text about the pieces of a folder, next to them: what request they are for.
    void put_note(const std::string& text) const;
    static std::optional<std::string> note_of(const std::filesystem::path& folder);

    // The versions whose pieces a folder has, and this one, as folders are named.
    static std::string version_folder();
    static std::set<std::string> versions_in(const std::filesystem::path& folder);

  private:
    std::vector<std::filesystem::path> folders_;
    std::string machine_;
};

}  // namespace pushfactor::demos::reports
