#include "demos/text/json_file.h"

#include "demos/text/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <vector>

namespace pushfactor::demos {

namespace {

constexpr std::uintmax_t most_bytes = 100'000'000;

// Locates the first error of a document.
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
    std::size_t position() const { return position_; }  // bytes that were read

    bool null() override { return value(); }
    bool boolean(bool) override { return value(); }
    bool number_integer(number_integer_t) override { return value(); }
    bool number_unsigned(number_unsigned_t) override { return value(); }
    bool number_float(number_float_t, const string_t&) override { return value(); }
    bool string(string_t&) override { return value(); }
    bool binary(binary_t&) override { return value(); }
    bool start_object(std::size_t) override { return open({.key = {}, .index = -1}); }
    bool key(string_t& name) override {
        levels_.back().key = name;
        return true;
    }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open({.key = {}, .index = 0}); }
    bool end_array() override { return close(); }
    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override {
        position_ = position;
        return false;
    }

  private:
    struct Level {
        std::string key;  // of the value that comes, in an object
        long index = -1;  // of the value that comes, in an array
    };
    bool open(const Level& level) {
        levels_.push_back(level);
        return true;
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

[[noreturn]] void refuse(const std::string& label, const std::string& text, const Json::exception& problem) {
    ErrorPlace place;
    Json::sax_parse(text, &place);
    const std::string path = place.path();
    const std::string word = word_at(text, std::max<std::size_t>(place.position(), 1));
    const bool too_large = dynamic_cast<const Json::out_of_range*>(&problem) != nullptr;
    if (!path.empty() && (too_large || is_not_finite(word))) {
        throw UsageError(fmt::format("{}: {} {}: must be a finite number", label, path, word));
    }
    const std::string what = problem.what();
    const std::string where = path.empty() ? "" : ", at " + path;
    throw UsageError(fmt::format("{}: is not JSON{}: {}", label, where, what.substr(what.find("] ") + 2)));
}

}  // namespace

Json read_json_file(const std::filesystem::path& file, const std::string& label) {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(file, error);
    std::ifstream stream(file, std::ios::binary);
    if (error || !stream) throw UsageError(fmt::format("{}: cannot be read", label));
    if (bytes > most_bytes) {
        throw UsageError(fmt::format("{}: must be at most {} bytes long, not {}", label, most_bytes, bytes));
    }
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    try {
        return Json::parse(text);
    } catch (const Json::exception& problem) {
        refuse(label, text, problem);
    }
}

}  // namespace pushfactor::demos
