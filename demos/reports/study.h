// Studies: many runs, compared or judged, as tables and plots on one page. The common part of all reports.
#pragma once

#include "demos/base/platform/progress.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/json.h"
#include "demos/base/text/shard.h"
#include "demos/base/text/text_hash.h"
#include "demos/options/named_run.h"
#include "demos/pages/page.h"
#include "demos/pages/table.h"
#include "demos/runs/session.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pushfactor::demos::reports {

// Pieces: the independent results that a report is made of. Each can be made alone, on any machine, and is kept in
// a JSON file (demos/FORMATS.md) with its "key", what it was "made_with", the "machine" and the "result".
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

// Of the pieces in a folder: their versions, and this one, as folders are named; and the text about them that lies
// beside those of this version: what request they are for.
std::set<std::string> piece_versions_in(const std::filesystem::path& folder);
std::string piece_version();
std::optional<std::string> piece_note_in(const std::filesystem::path& folder);

class StudyRun;
struct StudyRequest;

struct Study {
    std::string name;                               // as in the command: "error"
    std::string title;                              // of the page
    std::vector<std::string> (*parts)() = nullptr;  // for --only, listed when it is given
    void (*make)(StudyRun& run);
    bool judges = false;  // it writes verdicts

    // The pieces of a study that many processes can make; `make` then finds their results, and makes tables and
    // page.
    Pieces (*pieces)(const StudyRequest& request) = nullptr;
    int at_once = 0;  // pieces that are made at once; 0: one per processor
};

// A map of the atlas over any two options of any scene, as texts of the command line.
struct GridRequest {
    std::string scene, x, y;
    std::optional<std::string> measure{};  // the deepest overlap without
    std::vector<std::string> set{};        // "OPTION=VALUE", of all cells
    std::vector<std::string> replays{};    // "X:Y", or "all"

    bool operator==(const GridRequest&) const = default;
};

struct StudyRequest {
    std::filesystem::path folder;
    bool quick = false;                               // few and short runs
    std::optional<std::filesystem::path> beside{};    // points of other engines
    std::optional<std::filesystem::path> exported{};  // folder for frozen problems
    std::vector<std::string> parts{};                 // all when empty
    std::optional<std::string> junit{}, markdown{};   // paths, for the verdicts of a study that judges
    std::optional<GridRequest> grid{};                // for the atlas, instead of its maps

    // Of a study with pieces.
    std::optional<Shard> shard{};                 // make only the pieces of this share, and no page
    std::optional<int> jobs{};                    // pieces at once
    std::vector<std::filesystem::path> merged{};  // if not empty: make no piece, find all in these folders
    std::string note{};                           // stored with the pieces: what request they are for

    bool operator==(const StudyRequest&) const = default;

    bool wants(const std::string& part) const {
        return parts.empty() || std::ranges::find(parts, part) != parts.end();
    }

    // The things whose part was requested; `part_of` gives the part's name.
    template <typename Things, typename PartOf>
    Things wanted(Things things, const PartOf& part_of) const {
        std::erase_if(things, [&](const auto& thing) { return !wants(std::invoke(part_of, thing)); });
        return things;
    }
};

// Pieces of a merged report that are in none of its folders.
struct MissingPieces : RunError {
    MissingPieces(const std::string& message, std::vector<std::string> missing)
        : RunError(message), keys(std::move(missing)) {}

    std::vector<std::string> keys;
};

// A running study: its folder, request, progress and interruption, tables and page.
class StudyRun {
  public:
    StudyRun(const Study& study, StudyRequest request);

    bool quick() const { return request_.quick; }
    const StudyRequest& request() const { return request_; }
    const std::filesystem::path& folder() const { return request_.folder; }
    // Program, compiler and processor: this one, or those that made the pieces.
    const std::string& machine() const { return machine_; }

    // Sets the number of runs and of those already done; `hint` ends the message of an interruption.
    void begin(std::size_t runs, std::size_t done = 0, std::string hint = "");
    void count_run();
    StopCheck check() const;

    // Makes the pieces that are missing, or those of the share; throws MissingPieces where none may be made.
    void gather(const Pieces& pieces);

    // The result of a piece, if there is one; result() is for pieces that gather() made or found.
    std::optional<Json> find(const std::string& key) const;
    Json result(const std::string& key) const;

    // Of gather(): pieces of the request or the share, those that were there before, and those that failed.
    struct Count {
        std::size_t all = 0, there = 0, failed = 0;
    };
    const Count& count() const { return count_; }

    // Writes a file, whole or not at all, and makes the folder that `name` may have: "cells/a.html".
    void write(const std::string& name, const std::string& text) const;
    void write(const std::string& name, const Table& table) const;  // below a line with the machine
    // The same, and content with the table, its file and a caption.
    SectionContent tabulated(const std::string& name, const Table& table, const std::string& caption) const;

    std::vector<Section> sections{};
    void write_page(const std::string& opening) const;

  private:
    const Study& study_;
    StudyRequest request_;
    std::string machine_;
    std::vector<std::filesystem::path> stores_;  // pieces are looked for in all of them
    std::map<std::string, Json> failures_;       // of this process, by key
    Count count_;
    std::optional<ProgressBar> bar_;
    std::size_t runs_ = 0;
    std::atomic<std::size_t> done_ = 0;
    std::string hint_;
};

// Runs a study and writes its files. An interrupted one keeps its pieces, or the files of complete parts. Throws
// the exceptions of errors.h; CheckError if everything was written but a result is not as expected, or if pieces of
// a share failed.
StudyRun::Count make_study(const Study& study, const StudyRequest& request);

// Program, compiler and machine, without which times mean nothing: about.json.
std::string about_json();

Study error_study();      // errors of methods against their work
Study stability_study();  // judged extreme cases
Study cost_study();       // work and time per step
Study atlas_study();      // outcomes over two parameters
Study reality_study();    // measured motion beside computed motion
std::vector<Study> all_studies();

}  // namespace pushfactor::demos::reports
