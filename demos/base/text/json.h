// JSON as the program writes it: keys in the order in which they were set.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace pushfactor::demos {

using Json = nlohmann::ordered_json;

// What follows is compiled once: the templates of reading and writing take seconds of every file that uses them.

// Throws Json::parse_error.
Json parse_json(std::string_view text);

// Null if the text is not JSON.
Json json_or_null(std::string_view text);

// A string as it is, everything else as JSON.
std::string text_of(const Json& value);

// The text of an option as JSON: numbers as numbers, everything else as strings.
Json json_of(const std::string& text);

// The text of a file. Bytes that are no UTF-8, as names of files may have, become U+FFFD. `ascii`: other characters
// are escaped.
std::string json_text(const Json& json, int indent = 2, bool ascii = false);

}  // namespace pushfactor::demos
