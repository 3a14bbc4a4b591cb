// JSON as the program writes it: keys in the order in which they were set.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pushfactor::demos {

using Json = nlohmann::ordered_json;

// The text of an option as JSON: numbers as numbers, everything else as strings.
inline Json json_of(const std::string& text) {
    const Json parsed = Json::parse(text, nullptr, false);
    return parsed.is_number() ? parsed : Json(text);
}

// The text of a file. Bytes that are no UTF-8, as names of files may have, become U+FFFD.
inline std::string json_text(const Json& json, int indent = 2) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + (indent >= 0 ? "\n" : "");
}

}  // namespace pushfactor::demos
