#include "demos/commands/words.h"

#include "demos/base/platform/output_file.h"
#include "demos/base/platform/shell_words.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/suggest.h"
#include "demos/base/text/wrapped.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace pushfactor::demos {

namespace {

namespace fs = std::filesystem;

// Where a name leads to, through links; the folder need not exist yet.
fs::path place_of(const std::string& name) {
    std::error_code error;
    const fs::path place = fs::weakly_canonical(fs::absolute(followed(name)), error);
    return error ? fs::path(name) : place;
}

bool are_one_file(const std::string& a, const std::string& b) {
    std::error_code ignored;
    if (const auto open = named_descriptor(a)) return open == named_descriptor(b);
    // Devices such as /dev/null take any number of outputs.
    if (fs::is_character_file(a, ignored)) return false;
    return place_of(a) == place_of(b) || fs::equivalent(a, b, ignored);
}

// Whether a new folder of this name would be taken for one of the files that are written.
bool looks_like_file(const std::string& folder) {
    static const std::set<std::string> endings{".png",  ".svg", ".mp4", ".html", ".csv",
                                               ".json", ".glb", ".md",  ".xml"};
    std::error_code ignored;
    return endings.contains(fs::path(folder).extension()) && !fs::is_directory(folder, ignored);
}

// The headings of the options that are listed, in their order.
std::vector<std::string> groups_of(const std::vector<Option>& options) {
    std::vector<std::string> groups;
    for (const Option& option : options) {
        if (!option.group.empty() && std::ranges::find(groups, option.group) == groups.end()) {
            groups.push_back(option.group);
        }
    }
    return groups;
}

std::string usage_of(const Option& option) {
    return "--" + option.name + (option.placeholder.empty() ? "" : " " + option.placeholder);
}

// As a cell of a table in Markdown.
std::string cell_of(const std::string& text) {
    std::string cell;
    for (const char c : text) cell += c == '|' ? std::string("\\|") : std::string(1, c);
    return cell;
}

}  // namespace

Words::Words(std::string command, std::vector<Option> known, std::vector<std::string> arguments)
    : known_(std::move(known)) {
    std::vector<std::string> all = arguments;
    all.insert(all.begin(), std::move(command));
    line_ = command_of(all);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& word = arguments[i];
        if (word == "--") {
            names_.insert(names_.end(), arguments.begin() + static_cast<std::ptrdiff_t>(i) + 1, arguments.end());
            break;
        }
        if (word == "-" || !word.starts_with('-')) {
            names_.push_back(word);
            continue;
        }
        const std::size_t equals = word.find('=');
        const std::string name = word.starts_with("--") ? word.substr(2, equals - 2) : "";
        const auto found = std::ranges::find(known_, name, &Option::name);
        if (found == known_.end()) refuse_unknown(word.substr(0, equals));
        const bool is_flag = found->placeholder.empty();
        std::string value;
        if (is_flag) {
            if (equals != std::string::npos) throw UsageError(word + ": must be without a value");
        } else if (equals != std::string::npos) {
            value = word.substr(equals + 1);
        } else if (i + 1 < arguments.size() && !arguments[i + 1].starts_with("--")) {
            value = arguments[++i];
        }
        if (value.empty() && !is_flag) {
            throw UsageError("--{}: must have a value, {}", name, found->placeholder);
        }
        std::vector<std::string>& texts = given_[name];
        if (!texts.empty() && found->kind != OptionKind::list) {
            throw UsageError(
                is_flag ? fmt::format("--{}: must be given once", name)
                        : fmt::format("--{} {}: must be given once, not also {}", name, value, texts.front()));
        }
        texts.push_back(value);
    }
}

void Words::refuse_unknown(const std::string& word) const {
    // Was an option of `report error`.
    if (word == "--problems") {
        throw UsageError("--problems: contact problems of FCLib are solved by tests/compare problems FILE|DIR");
    }
    std::vector<std::string> names;
    for (const Option& option : known_) names.push_back("--" + option.name);
    throw UsageError(word + ": unknown option" + suggestion(word, names));
}

const Option& Words::known(std::string_view option) const {
    const auto found = std::ranges::find(known_, option, &Option::name);
    if (found == known_.end()) throw std::logic_error(fmt::format("--{} is in no table of options", option));
    return *found;
}

std::optional<std::string> Words::peek(std::string_view option) const {
    const auto found = given_.find(option);
    return found == given_.end() ? std::nullopt : std::optional(found->second.front());
}

std::string Words::field(const std::string& option) const {
    const std::string& text = given_.find(option)->second.front();
    return "--" + option + (text.empty() ? "" : " " + text);
}

std::vector<std::string> Words::take_all(std::string_view option) {
    const Option& one = known(option);
    const auto found = given_.find(option);
    if (found == given_.end()) return {};
    if (taken_.insert(one.name).second) {
        for (const std::string& text : found->second) {
            if (one.kind == OptionKind::reads) reads_.push_back({field(one.name), text});
            if (one.kind == OptionKind::writes) writes_.push_back({field(one.name), text});
            if (one.placeholder != "DIR") continue;
            if (looks_like_file(text)) throw UsageError("{}: must be the name of a folder", field(one.name));
            folders_.push_back({field(one.name), text});
        }
    }
    return found->second;
}

std::optional<std::string> Words::take(std::string_view option) {
    const std::vector<std::string> texts = take_all(option);
    if (texts.empty()) return std::nullopt;
    return texts.front();
}

std::optional<std::string> Words::take(std::string_view option, bool has_effect, std::string_view must) {
    if (!has_effect && given(option)) throw UsageError("{}: must be {}", field(std::string(option)), must);
    return take(option);
}

std::optional<std::string> Words::take_word(std::string_view option, const std::vector<std::string>& words) {
    auto text = take(option);
    if (text && std::ranges::find(words, *text) == words.end()) {
        throw UsageError("--{} {}: must be {}", option, *text, fmt::join(words, " or "));
    }
    return text;
}

std::optional<int> Words::take_whole(std::string_view option, int low, int high) {
    const auto text = take(option);
    if (!text) return std::nullopt;
    if (const auto number = parse_integer(*text, low, high)) return number;
    throw UsageError("--{} {}: must be a whole number from {} to {}", option, *text, low, high);
}

std::optional<Shard> Words::take_shard(std::string_view option) {
    const auto text = take(option);
    if (!text) return std::nullopt;
    if (const auto shard = parse_shard(*text)) return shard;
    throw UsageError("--{} {}: must be K/N with 1 <= K <= N <= 1000000", option, *text);
}

std::vector<std::string> Words::take_names() {
    names_taken_ = true;
    return names_;
}

void Words::refuse_rest(std::string_view command) const {
    for (const auto& [option, texts] : given_) {
        if (!taken_.contains(option)) throw UsageError("{}: must not be with {}", field(option), command);
    }
    if (!names_taken_ && !names_.empty()) throw UsageError("{}: must not be with {}", names_.front(), command);
    for (std::size_t i = 0; i < writes_.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (are_one_file(writes_[i].name, writes_[k].name)) {
                throw UsageError("{}: must not be the file of {}", writes_[i].field, writes_[k].field);
            }
        }
        for (const NamedFile& input : reads_) {
            if (input.name != "-" && are_one_file(writes_[i].name, input.name)) {
                throw UsageError("{}: must not be a file that is read, {}", writes_[i].field, input.field);
            }
        }
    }
}

void require_own_endings(const std::string& folder, const std::optional<std::string>& junit,
                         const std::optional<std::string>& markdown) {
    for (const auto& [option, file, ending] :
         {std::tuple{"junit", &junit, ".xml"}, std::tuple{"markdown", &markdown, ".md"}}) {
        if (!*file || is_stream(**file) || !is_below(folder, **file)) continue;
        if (followed(**file).extension() == ending) continue;
        throw UsageError("--{} {}: must end in {} within {}, where other files may have this name", option, **file,
                         ending, folder);
    }
}

std::string help_of(const std::vector<Option>& options) {
    constexpr std::size_t indent = 30, width = 100;
    const std::string next_line = "\n" + std::string(indent, ' ');
    const auto fits = [](const std::string& line) { return indent + line.size() <= width; };
    std::string text;
    for (const std::string& group : groups_of(options)) {
        text += "\n" + group + ":\n";
        for (const Option& option : options) {
            if (option.group != group) continue;
            const std::string head = "  " + usage_of(option);
            const std::string gap = head.size() + 2 > indent ? next_line : std::string(indent - head.size(), ' ');
            text += fmt::format("{}{}{}\n", head, gap, fmt::join(wrapped(option.help, fits), next_line));
        }
    }
    return text;
}

std::vector<std::pair<std::string, std::string>> markdown_of(const std::vector<Option>& options) {
    std::vector<std::pair<std::string, std::string>> tables;
    for (const std::string& group : groups_of(options)) {
        std::string table = "| option | |\n|---|---|\n";
        for (const Option& option : options) {
            if (option.group != group) continue;
            table += fmt::format("| `{}` | {} |\n", cell_of(usage_of(option)), cell_of(option.help));
        }
        tables.emplace_back(group, table);
    }
    return tables;
}

}  // namespace pushfactor::demos
