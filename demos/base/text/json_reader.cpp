#include "demos/base/text/json_reader.h"

#include "demos/base/text/errors.h"
#include "demos/base/text/input.h"
#include "demos/base/text/numbers.h"
#include "demos/base/text/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace pushfactor::demos {

namespace {

constexpr double largest = std::numeric_limits<double>::max();

// Long values would make a long line.
std::string shortened(const Json& value) {
    std::string text = json_text(value, -1);
    if (text.size() > 60) text = text.substr(0, 57) + "...";
    return text;
}

}  // namespace

void JsonReader::refuse(const std::string& allowed) const {
    throw UsageError("{}: {} {}: must be {}", file_, path_.empty() ? "the file" : path_, shortened(value_),
                     allowed);
}

void JsonReader::require_object() const {
    if (!value_.is_object()) refuse("an object");
}

void JsonReader::require_object(std::span<const std::string> known) const {
    require_object();
    for (const auto& [key, value] : value_.items()) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        throw UsageError("{}: {}{}{}: unknown key{}", file_, path_, path_.empty() ? "" : ".", key,
                         nearest_or_all(key, known));
    }
}

JsonReader JsonReader::at(const std::string& key) const {
    const auto found = value_.find(key);
    const std::string path = path_.empty() ? key : path_ + "." + key;
    if (found == value_.end()) throw UsageError("{}: {}: is missing", file_, path);
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
    return number(low, high, fmt::format("a number from {} to {}", to_text(low), to_text(high)));
}

double JsonReader::number(double low, double high, const std::string& allowed) const {
    if (!value_.is_number()) refuse(allowed);
    const double number = value_.get<double>();
    if (!(number >= low && number <= high)) refuse(allowed);
    return number;
}

double JsonReader::positive() const {
    return number(std::numeric_limits<double>::denorm_min(), largest, "a number above 0");
}

double JsonReader::not_negative() const {
    return number(0.0, largest, "a number of at least 0");
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

namespace {

constexpr std::size_t most_levels = 100;  // what reads values is recursive

// Locates the first error of a document: of its text, a key that is twice in an object, or too many levels.
class ErrorPlace : public nlohmann::json_sax<Json> {
  public:
    // "bodies[0].mass_kg"; empty for the document as a whole.
    std::string path() const {
        std::string path;
        for (const Level& level : levels_) {
            if (level.index >= 0) {
                path += fmt::format("[{}]", level.index);
            } else if (!level.key.empty()) {
                path += (path.empty() ? "" : ".") + level.key;
            }
        }
        return path;
    }
    const std::string& fault() const { return fault_; }  // empty for an error of the text

    // Of the text: bytes that were read, the parser's message, and whether a number is beyond double.
    std::size_t position() const { return position_; }
    const std::string& message() const { return message_; }
    bool is_too_large() const { return is_too_large_; }

    bool null() override { return value(); }
    bool boolean(bool) override { return value(); }
    bool number_integer(number_integer_t) override { return value(); }
    bool number_unsigned(number_unsigned_t) override { return value(); }
    bool number_float(number_float_t, const string_t&) override { return value(); }
    bool string(string_t& text) override { return has_no_zero(text) && value(); }
    bool binary(binary_t&) override { return value(); }
    bool start_object(std::size_t) override { return open({.key = {}, .index = -1}); }
    bool key(string_t& name) override {
        levels_.back().key = name;
        if (!has_no_zero(name)) return false;
        if (levels_.back().keys.insert(name).second) return true;
        fault_ = "must be given once";
        return false;
    }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open({.key = {}, .index = 0}); }
    bool end_array() override { return close(); }
    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override {
        position_ = position;
        message_ = error.what();
        is_too_large_ = dynamic_cast<const Json::out_of_range*>(&error) != nullptr;
        return false;
    }

  private:
    struct Level {
        std::string key;  // of the value that comes, in an object
        long index = -1;  // of the value that comes, in an array
        std::set<std::string> keys{};
    };
    bool open(const Level& level) {
        levels_.push_back(level);
        if (levels_.size() <= most_levels) return true;
        fault_ = fmt::format("must have at most {} levels", most_levels);
        return false;
    }
    // It ends the name of a file.
    bool has_no_zero(const string_t& text) {
        if (text.find('\0') == string_t::npos) return true;
        fault_ = "must be without \\u0000";
        return false;
    }
    bool close() {
        levels_.pop_back();
        return value();
    }
    bool value() {
        if (!levels_.empty() && levels_.back().index >= 0) ++levels_.back().index;
        return true;
    }

    std::vector<Level> levels_;
    std::size_t position_ = 0;
    std::string fault_, message_;
    bool is_too_large_ = false;
};

// The word of `text` around `position`.
std::string word_at(const std::string& text, std::size_t position) {
    constexpr std::size_t longest = 40;
    const char* const delimiters = " \t\r\n,:[]{}";
    const std::size_t before = text.find_last_of(delimiters, position - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    return text.substr(begin, std::min(text.find_first_of(delimiters, begin) - begin, longest));
}

// Spellings of non-finite numbers by other programs; JSON has none.
bool is_not_finite(std::string word) {
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    if (word.starts_with('-') || word.starts_with('+')) word.erase(0, 1);
    return word == "nan" || word == "inf" || word == "infinity";
}

[[noreturn]] void refuse(const std::string& label, const std::string& text, const ErrorPlace& place) {
    const std::string path = place.path();
    // Deep paths are long.
    if (!place.fault().empty()) {
        throw UsageError("{}: {}{}: {}", label, path.substr(0, 60), path.size() > 60 ? "..." : "", place.fault());
    }
    const std::string word = word_at(text, std::max<std::size_t>(place.position(), 1));
    if (!path.empty() && (place.is_too_large() || is_not_finite(word))) {
        throw UsageError("{}: {} {}: must be a finite number", label, path, word);
    }
    const std::string where = path.empty() ? "" : ", at " + path;
    throw UsageError("{}: is not JSON{}: {}", label, where, place.message().substr(place.message().find("] ") + 2));
}

}  // namespace

Json read_json_file(const std::filesystem::path& file, const std::string& label) {
    const std::string text = read_input(file, label);
    // The parser takes a zero byte for the end.
    if (const std::size_t zero = text.find('\0'); zero != std::string::npos) {
        throw UsageError("{}: is not JSON: byte {} is zero", label, zero + 1);
    }
    ErrorPlace place;
    if (!Json::sax_parse(text, &place)) refuse(label, text, place);
    return parse_json(text);
}

}  // namespace pushfactor::demos
