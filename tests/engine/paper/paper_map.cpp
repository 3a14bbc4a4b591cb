#include "tests/engine/paper/paper_map.h"

#include <algorithm>
#include <cctype>

namespace pushfactor::tests {

namespace {

bool in_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool has_word(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool begins = at == 0 || !in_word(text[at - 1]);
        if (begins && (end == text.size() || !in_word(text[end]))) return true;
    }
    return false;
}

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin == std::string::npos) return {};
    return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

std::string without_comments(const std::string& code) {
    std::string rest;
    for (const std::string& line : lines_of(code)) rest += line.substr(0, line.find("//")) + '\n';
    return rest;
}

// The cells between the bars; "\|" is a bar within a cell.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::string cell;
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|') {
            cell += line[++i];
        } else if (line[i] == '|') {
            cells.push_back(trimmed(cell));
            cell.clear();
        } else {
            cell += line[i];
        }
    }
    return cells;
}

// The text between backticks.
std::vector<std::string> quoted(const std::string& text) {
    std::vector<std::string> found;
    for (std::size_t open = text.find('`'); open != std::string::npos; open = text.find('`', open)) {
        const std::size_t close = text.find('`', open + 1);
        if (close == std::string::npos) break;
        found.push_back(text.substr(open + 1, close - open - 1));
        open = close + 1;
    }
    return found;
}

// The numbers after "erratum" or "errata": "errata 1, 2 and 3".
std::vector<int> cited(const std::string& text) {
    std::vector<int> numbers;
    for (const char* const word : {"erratum ", "errata "}) {
        const std::size_t at = text.find(word);
        if (at == std::string::npos) continue;
        std::size_t i = at + std::string_view(word).size();
        while (i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0) {
            std::size_t length = 0;
            numbers.push_back(std::stoi(text.substr(i), &length));
            i += length;
            if (text.compare(i, 2, ", ") == 0) i += 2;
            if (text.compare(i, 5, " and ") == 0) i += 5;
        }
    }
    return numbers;
}

struct Erratum {
    int number = 0;
    std::vector<std::string> tests;
};

// The parts under "### 12. title".
std::vector<Erratum> errata_of(const std::string& text) {
    std::vector<Erratum> errata;
    for (const std::string& line : lines_of(text)) {
        if (line.starts_with("### ") && line.size() > 4 && std::isdigit(static_cast<unsigned char>(line[4])) != 0) {
            errata.push_back({.number = std::stoi(line.substr(4)), .tests = {}});
        } else if (line.starts_with("Test: ") && !errata.empty()) {
            errata.back().tests = quoted(line);
        }
    }
    return errata;
}

class Checker {
  public:
    Checker(const Sources& sources, const std::string& errata)
        : sources_(sources), tests_(test_names(sources)), errata_(errata_of(errata)) {}

    void check(const MapEntry& entry) {
        if (entry.status.empty()) {
            fault(entry.place, "has not five cells");
            return;
        }
        check_places(entry);
        check_tests(entry);
        check_status(entry);
    }

    void check_errata() {
        for (std::size_t i = 0; i < errata_.size(); ++i) {
            const std::string name = "erratum " + std::to_string(errata_[i].number);
            if (errata_[i].number != static_cast<int>(i) + 1) fault(name, "is out of order");
            if (errata_[i].tests.empty()) fault(name, "has no test");
            for (const std::string& test : errata_[i].tests) check_test(name, test);
            if (!cited_.contains(errata_[i].number)) fault(name, "is not cited in the map");
        }
    }

    void fault(const std::string& where, const std::string& what) { faults_.push_back(where + ": " + what); }
    std::vector<std::string> faults() { return std::move(faults_); }

  private:
    static bool is_unused(const MapEntry& entry) { return entry.status.starts_with("not used, because "); }

    void check_places(const MapEntry& entry) {
        std::string code, path;
        bool named = true;
        int names = 0;
        for (const std::string& word : quoted(entry.where)) {
            if (word.find('/') != std::string::npos) {
                if (!named) fault(entry.place, path + " has no name in it");
                const auto file = sources_.find(word);
                if (file == sources_.end()) fault(entry.place, "there is no file " + word);
                code = file == sources_.end() ? "" : without_comments(file->second);
                path = word;
                named = false;
            } else {
                named = true;
                ++names;
                if (!has_word(code, word)) fault(entry.place, "there is no " + word + " in " + path);
            }
        }
        if (!named) fault(entry.place, path + " has no name in it");
        if (names == 0 && !is_unused(entry)) fault(entry.place, "has no function or type");
    }

    void check_tests(const MapEntry& entry) {
        const std::vector<std::string> names = quoted(entry.test);
        for (const std::string& name : names) check_test(entry.place, name);
        if (!names.empty()) return;
        if (!is_unused(entry)) {
            fault(entry.place, "has no test");
        } else if (!entry.test.starts_with("none, because ")) {
            fault(entry.place, "has neither a test nor a reason why there is none");
        }
    }

    void check_test(const std::string& where, const std::string& name) {
        if (!tests_.contains(name)) fault(where, "there is no test \"" + name + "\"");
    }

    void check_status(const MapEntry& entry) {
        const std::vector<int> numbers = cited(entry.status);
        for (const int number : numbers) {
            cited_.insert(number);
            const auto is_it = [&](const Erratum& erratum) { return erratum.number == number; };
            if (std::none_of(errata_.begin(), errata_.end(), is_it)) {
                fault(entry.place, "there is no erratum " + std::to_string(number));
            }
        }
        const bool corrected = entry.status.starts_with("corrected, ");
        if (corrected && numbers.empty()) fault(entry.place, "is corrected by no erratum");
        if (!corrected && !entry.status.starts_with("as written") && !is_unused(entry)) {
            fault(entry.place, "status \"" + entry.status + "\" is none of the three");
        }
    }

    const Sources& sources_;
    std::set<std::string> tests_;
    std::vector<Erratum> errata_;
    std::set<int> cited_;
    std::vector<std::string> faults_;
};

}  // namespace

std::set<std::string> test_names(const Sources& sources) {
    std::set<std::string> names;
    constexpr std::string_view opening = "TEST_CASE(";
    for (const auto& [path, text] : sources) {
        if (!path.starts_with("tests/") || !path.ends_with(".cpp")) continue;
        for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at + 1)) {
            // Adjacent string literals are one.
            std::string name;
            std::size_t i = text.find_first_not_of(" \n", at + opening.size());
            while (i < text.size() && text[i] == '"') {
                for (++i; i < text.size() && text[i] != '"'; ++i) {
                    if (text[i] == '\\') ++i;
                    name += text[i];
                }
                i = text.find_first_not_of(" \n", i + 1);
            }
            if (!name.empty()) names.insert(name);
        }
    }
    return names;
}

std::vector<MapEntry> map_entries(const std::string& map) {
    std::vector<MapEntry> entries;
    bool in_map = false;
    int table_lines = 0;
    for (const std::string& line : lines_of(map)) {
        if (line.starts_with("# ")) in_map = line == "# The paper map";
        if (!in_map || !line.starts_with("|")) {
            table_lines = 0;
            continue;
        }
        if (++table_lines <= 2) continue;  // the header and the line below it
        const std::vector<std::string> cells = cells_of(line);
        entries.push_back(cells.size() == 5
                              ? MapEntry{cells[0], cells[1], cells[2], cells[3], cells[4]}
                              : MapEntry{.place = line, .says = {}, .where = {}, .test = {}, .status = {}});
    }
    return entries;
}

std::vector<std::string> map_faults(const std::string& map, const std::string& errata, const Sources& sources,
                                    std::span<const std::string> wanted) {
    Checker checker(sources, errata);
    const std::vector<MapEntry> entries = map_entries(map);
    for (const MapEntry& entry : entries) checker.check(entry);
    checker.check_errata();
    for (const std::string& place : wanted) {
        const auto has_it = [&](const MapEntry& entry) { return has_word(entry.place, place); };
        if (std::none_of(entries.begin(), entries.end(), has_it)) checker.fault(place, "is not in the map");
    }
    return checker.faults();
}

}  // namespace pushfactor::tests
