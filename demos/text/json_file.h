// JSON files that somebody wrote by hand.
#pragma once

#include "demos/text/json.h"

#include <filesystem>
#include <string>

namespace pushfactor::demos {

// The document in `file`. `label` is how messages call the file. Throws UsageError, one line, when the file cannot
// be read, is longer than 100 MB or is no JSON: then with the path of the value at which it ends being JSON, so
// that NaN, Infinity and numbers beyond double are refused by the name of their field.
Json read_json_file(const std::filesystem::path& file, const std::string& label);

}  // namespace pushfactor::demos
