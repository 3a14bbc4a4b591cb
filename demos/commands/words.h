// The words after a command. A command takes the options that it reads in the given combination; what is left is
// refused, so that nothing is ignored.
#pragma once

#include "demos/base/text/shard.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pushfactor::demos {

enum class OptionKind {
    value,
    list,    // may be repeated
    reads,   // a file that is read
    writes,  // a file that is written
};

struct Option {
    std::string name;         // without the leading dashes
    std::string placeholder;  // of the value, in help texts; empty for a flag, which has none
    std::string help;
    std::string group = "Options";  // heading in the help text; options without one are not listed
    OptionKind kind = OptionKind::value;
};

struct NamedFile {
    std::string field;  // "--csv a.csv"
    std::string name;
};

class Words {
  public:
    // Throws UsageError for an option that is not in the table, a missing value, or an option given twice.
    Words(std::string command, std::vector<Option> known, std::vector<std::string> arguments);

    bool given(std::string_view option) const { return given_.contains(option); }

    std::optional<std::string> peek(std::string_view option) const;  // the value, not taken

    // The value; none if the option was not given. Throws std::logic_error for an option that is not in the table.
    std::optional<std::string> take(std::string_view option);
    // The same where the option has an effect only if `has_effect`; otherwise it is refused, because it `must` be
    // "with --replay".
    std::optional<std::string> take(std::string_view option, bool has_effect, std::string_view must);
    bool take_flag(std::string_view option) { return take(option).has_value(); }
    std::vector<std::string> take_all(std::string_view option);
    // The value, which has to be one of these words, a whole number from `low` to `high`, or a shard.
    std::optional<std::string> take_word(std::string_view option, const std::vector<std::string>& words);
    std::optional<int> take_whole(std::string_view option, int low, int high);
    std::optional<Shard> take_shard(std::string_view option);

    // The words that are no options: scenes, figures, folders.
    std::vector<std::string> take_names();
    // A file that is read without an option for it.
    void reads(const std::string& file) { reads_.push_back({file, file}); }

    // Throws UsageError for what was not taken, and for a file that is written twice, or read and written.
    // `command` says in which combination: "render --join".
    void refuse_rest(std::string_view command) const;

    // Files that the options that were taken write.
    const std::vector<NamedFile>& outputs() const { return writes_; }
    const std::vector<NamedFile>& folders() const { return folders_; }  // of the options that were taken

    const std::string& line() const { return line_; }  // as typed, quoted where a shell needs it

  private:
    const Option& known(std::string_view option) const;
    [[noreturn]] void refuse_unknown(const std::string& word) const;
    std::string field(const std::string& option) const;  // "--csv a.csv"

    std::vector<Option> known_;
    std::map<std::string, std::vector<std::string>, std::less<>> given_;
    std::vector<std::string> names_;
    std::set<std::string, std::less<>> taken_;
    bool names_taken_ = false;
    std::vector<NamedFile> reads_, writes_, folders_;
    std::string line_;
};

// Throws UsageError for a file of --junit or --markdown in or below the folder, unless it ends in .xml or .md, as
// no other file there does, and so replaces none.
void require_own_endings(const std::string& folder, const std::optional<std::string>& junit,
                         const std::optional<std::string>& markdown);

// The options as a help text, by group.
std::string help_of(const std::vector<Option>& options);

// The groups in their order, each with its options as a table in Markdown.
std::vector<std::pair<std::string, std::string>> markdown_of(const std::vector<Option>& options);

}  // namespace pushfactor::demos
