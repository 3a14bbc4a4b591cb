// Pieces: the independent results that a report is made of. Each can be made alone, on any machine.
#pragma once

#include "demos/options/named_run.h"
#include "demos/text/json.h"
#include "demos/text/text_hash.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports {

struct Piece {
    // One line that names report, experiment and every option that decides the result.
    std::string key;

    // Makes the result, on any thread. Calls its argument often, whose exceptions end it. A result with a member
    // "failed" (a text) is not stored: it is made again next time.
    std::function<Json(const std::function<void()>& check)> make;
};
using Pieces = std::vector<Piece>;

// Number that decides the shard and the file of a piece.
inline std::uint64_t hash_of_key(const std::string& key) {
    return text_hash(key);
}

// Key of a run of a scene of the catalogue, of a file in assets/scenes, or of the file "PATH.json": its options,
// and of a file its content, not its path.
std::string run_key(const std::string& scene, const OptionTexts& options);

// JSON has no infinity and no NaN: these become texts. Readers throw std::exception for JSON of another form.
Json json_number(double value);
double number_in(const Json& json);
Json json_numbers(const std::vector<double>& values);
std::vector<double> numbers_in(const Json& json);

// The page that plays the run, with poses only. `check` is called at each step; its exceptions end the run.
std::string replay_of(const std::string& scene, const OptionTexts& options, const std::function<void()>& check);

}  // namespace pushfactor::demos::reports
