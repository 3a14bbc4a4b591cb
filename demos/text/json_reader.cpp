#include "demos/text/json_reader.h"

#include "demos/text/errors.h"
#include "demos/text/numbers.h"
#include "demos/text/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pushfactor::demos {

namespace {

// Long values would make a long line.
std::string shortened(const Json& value) {
    std::string text = value.dump();
    if (text.size() > 60) text = text.substr(0, 57) + "...";
    return text;
}

}  // namespace

void JsonReader::refuse(const std::string& allowed) const {
    throw UsageError(fmt::format("{}: {} {}: must be {}", file_, path_.empty() ? "the file" : path_,
                                 shortened(value_), allowed));
}

void JsonReader::require_object() const {
    if (!value_.is_object()) refuse("an object");
}

void JsonReader::require_object(std::span<const std::string> known) const {
    require_object();
    for (const auto& [key, value] : value_.items()) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        throw UsageError(fmt::format("{}: {}{}{}: unknown key{}", file_, path_, path_.empty() ? "" : ".", key,
                                     suggestion(key, known)));
    }
}

JsonReader JsonReader::at(const std::string& key) const {
    const auto found = value_.find(key);
    const std::string path = path_.empty() ? key : path_ + "." + key;
    if (found == value_.end()) throw UsageError(fmt::format("{}: {}: is missing", file_, path));
    return {*found, file_, path};
}

std::vector<JsonReader> JsonReader::elements() const {
    if (!value_.is_array()) refuse("an array");
    std::vector<JsonReader> elements;
    elements.reserve(value_.size());
    for (std::size_t i = 0; i < value_.size(); ++i) {
        elements.emplace_back(value_[i], file_, fmt::format("{}[{}]", path_, i));
    }
    return elements;
}

double JsonReader::number(double low, double high) const {
    const std::string allowed = fmt::format("a number from {} to {}", to_text(low), to_text(high));
    if (!value_.is_number()) refuse(allowed);
    const double number = value_.get<double>();
    if (!(number >= low && number <= high)) refuse(allowed);
    return number;
}

double JsonReader::positive() const {
    if (!value_.is_number() || !(value_.get<double>() > 0.0) || !std::isfinite(value_.get<double>())) {
        refuse("a number above 0");
    }
    return value_.get<double>();
}

double JsonReader::not_negative() const {
    if (!value_.is_number() || !(value_.get<double>() >= 0.0) || !std::isfinite(value_.get<double>())) {
        refuse("a number of at least 0");
    }
    return value_.get<double>();
}

bool JsonReader::boolean() const {
    if (!value_.is_boolean()) refuse("true or false");
    return value_.get<bool>();
}

std::string JsonReader::string() const {
    if (!value_.is_string()) refuse("a string");
    return value_.get<std::string>();
}

std::vector<double> JsonReader::numbers(std::size_t count, const std::string& allowed) const {
    if (!value_.is_array() || value_.size() != count) refuse(allowed);
    std::vector<double> numbers;
    for (const Json& element : value_) {
        if (!element.is_number() || !std::isfinite(element.get<double>())) refuse(allowed);
        numbers.push_back(element.get<double>());
    }
    return numbers;
}

engine::Vector3 JsonReader::vector() const {
    const std::vector<double> n = numbers(3, "three numbers [x, y, z]");
    return {n[0], n[1], n[2]};
}

engine::Quaternion JsonReader::rotation() const {
    const std::string allowed = "a quaternion [w, x, y, z] of length 1";
    const std::vector<double> n = numbers(4, allowed);
    engine::Quaternion q(n[0], n[1], n[2], n[3]);
    if (std::abs(q.norm() - 1.0) > 1e-6) refuse(allowed);
    return q;
}

}  // namespace pushfactor::demos
