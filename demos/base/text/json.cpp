#include "demos/base/text/json.h"

namespace pushfactor::demos {

Json parse_json(std::string_view text) {
    return Json::parse(text);
}

Json json_or_null(std::string_view text) {
    Json json = Json::parse(text, nullptr, false);
    return json.is_discarded() ? Json() : json;
}

std::string text_of(const Json& value) {
    return value.is_string() ? value.get<std::string>() : json_text(value, -1);
}

Json json_of(const std::string& text) {
    Json json = json_or_null(text);
    return json.is_number() ? json : Json(text);
}

std::string json_text(const Json& json, int indent, bool ascii) {
    return json.dump(indent, ' ', ascii, Json::error_handler_t::replace) + (indent >= 0 ? "\n" : "");
}

}  // namespace pushfactor::demos
