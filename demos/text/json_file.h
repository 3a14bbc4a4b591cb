// Hand-written JSON files.
#pragma once

#include "demos/text/json.h"

#include <filesystem>
#include <string>

namespace pushfactor::demos {

// The document in `file`. `label` is the name of the file in messages. Throws UsageError, one line, if the file
// cannot be read, is longer than 100 MB or is not JSON: then with the path of the first wrong value, so that NaN,
// Infinity and numbers beyond double are reported by the name of their field.
Json read_json_file(const std::filesystem::path& file, const std::string& label);

}  // namespace pushfactor::demos
