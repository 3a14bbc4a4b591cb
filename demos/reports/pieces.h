// Pieces: the independent results that a report is made of. Each can be made alone, on any machine, and is kept in
// a JSON file,
//
//   FOLDER/pieces/VERSION/ab/0123456789abcd.json     ab0123456789abcd: hash of the key
//   {"key": "...", "made_with": "...", "machine": "...", "result": ...}
//
// VERSION is that of the program, so that no version ever uses the pieces of another. A program that was built from
// modified or unknown sources adds a hash of its own file.
#pragma once

#include "demos/options/named_run.h"
#include "demos/platform/progress.h"
#include "demos/text/json.h"
#include "demos/text/text_hash.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pushfactor::demos::reports {

struct Piece {
    // One line that names report, experiment and every option that decides the result. Its text_hash() decides the
    // shard and the file.
    std::string key;

    // Makes the result, on any thread. One with a member "failed" (a text) is not stored: it is made again next
    // time.
    std::function<Json(const StopCheck& check)> make;
};
using Pieces = std::vector<Piece>;

// Key of a run of a scene of the catalogue, of a file in assets/scenes, or of the file "PATH.json": its options,
// and of a file its content, not its path.
std::string run_key(const std::string& scene, const OptionTexts& options);

// JSON has no infinity and no NaN: these become texts. Readers throw std::exception for JSON of another form.
Json json_number(double value);
double number_in(const Json& json);
Json json_numbers(const std::vector<double>& values);
std::vector<double> numbers_in(const Json& json);

// The page that plays the run, with poses only.
std::string replay_of(const std::string& scene, const OptionTexts& options, const StopCheck& check);

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
