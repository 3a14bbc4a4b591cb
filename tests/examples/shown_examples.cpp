#include "tests/examples/shown_examples.h"

#include <optional>
#include <set>

namespace pushfactor::tests {

namespace {

// The text between `opening` and `closing` when the line begins and ends with them.
std::optional<std::string> between(const std::string& line, std::string_view opening, std::string_view closing) {
    if (line.size() < opening.size() + closing.size()) return std::nullopt;
    if (!line.starts_with(opening) || !line.ends_with(closing)) return std::nullopt;
    return line.substr(opening.size(), line.size() - opening.size() - closing.size());
}

class Checker {
  public:
    // "file: name" -> the lines of the region.
    void read_regions(const std::string& file, const std::string& text) {
        std::string open;
        for (const std::string& line : lines_of(text)) {
            if (const auto name = between(line, "// [example: ", "]")) {
                if (!open.empty()) fault(open, "has no end");
                open = file + ": " + *name;
                if (!regions_.emplace(open, "").second) fault(open, "is there twice");
            } else if (line == "// [end]") {
                open.clear();
            } else if (!open.empty()) {
                regions_[open] += line + "\n";
            }
        }
        if (!open.empty()) fault(open, "has no end");
    }

    void read_page(const std::string& page, const std::string& text) {
        std::string mark, block;
        bool in_block = false;
        for (const std::string& line : lines_of(text)) {
            if (in_block && line == "```") {
                in_block = false;
                if (!mark.empty()) compare(page, mark, block);
                mark.clear();
            } else if (in_block) {
                block += line + "\n";
            } else if (line == "```cpp") {
                in_block = true;
                block.clear();
                if (mark.empty()) fault(page, "shows C++ without saying whose");
            } else {
                if (!mark.empty()) fault(page, "marks " + mark + " and does not show it");
                mark = between(line, "<!-- ", " -->").value_or("");
            }
        }
        if (in_block) fault(page, "has a block without an end");
        if (!in_block && !mark.empty()) fault(page, "marks " + mark + " and does not show it");
    }

    std::vector<std::string> faults() {
        for (const auto& [name, text] : regions_) {
            if (!shown_.contains(name)) fault(name, "is shown nowhere");
        }
        return std::move(faults_);
    }

  private:
    void compare(const std::string& page, const std::string& mark, const std::string& block) {
        const auto region = regions_.find(mark);
        if (region == regions_.end()) {
            fault(page, "shows " + mark + ", which is not there");
            return;
        }
        shown_.insert(mark);
        if (block != region->second) fault(page, "shows another " + mark + " than there is");
    }

    void fault(const std::string& where, const std::string& what) { faults_.push_back(where + " " + what); }

    std::map<std::string, std::string> regions_;
    std::set<std::string> shown_;
    std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> example_faults(const Sources& pages, const Sources& sources) {
    Checker checker;
    for (const auto& [file, text] : sources) checker.read_regions(file, text);
    for (const auto& [page, text] : pages) checker.read_page(page, text);
    return checker.faults();
}

}  // namespace pushfactor::tests
