// Hand-written JSON files: every error message names the file, the path inside it, the value and what is
// allowed.
#pragma once

#include "demos/base/text/json.h"
#include "engine/base/math.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos {

// A place inside a JSON document. All members throw UsageError.
class JsonReader {
  public:
    JsonReader(const Json& value, std::string file, std::string path = "")
        : value_(value), file_(std::move(file)), path_(std::move(path)) {}

    [[noreturn]] void refuse(const std::string& allowed) const;

    // Objects. An unknown key is refused with the nearest known one.
    void require_object() const;
    void require_object(std::span<const std::string> known) const;
    bool has(const std::string& key) const { return value_.contains(key); }
    JsonReader at(const std::string& key) const;  // the key must be there
    const Json& json() const { return value_; }

    std::vector<JsonReader> elements() const;  // of an array

    double number(double low, double high) const;                              // finite, both ends included
    double number(double low, double high, const std::string& allowed) const;  // as `allowed` says in the message
    double positive() const;
    double not_negative() const;
    bool boolean() const;
    std::string string() const;
    engine::Vector3 vector() const;       // [x, y, z]
    engine::Quaternion rotation() const;  // [w, x, y, z], of length 1 to within 1e-6

    // An array of `count` finite numbers; `allowed` describes it in the message.
    std::vector<double> numbers(std::size_t count, const std::string& allowed) const;

  private:
    const Json& value_;
    std::string file_, path_;
};

// The document in `file`. `label` is the name of the file in messages. Throws UsageError, one line, if the file
// cannot be read, is longer than 100 MB or is not JSON: then with the path of the first wrong value, so that NaN,
// Infinity and numbers beyond double are reported by the name of their field.
Json read_json_file(const std::filesystem::path& file, const std::string& label);

}  // namespace pushfactor::demos
