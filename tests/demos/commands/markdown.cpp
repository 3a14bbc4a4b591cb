#include "tests/demos/commands/markdown.h"

#include "tests/texts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>

namespace pushfactor::tests {

namespace {

namespace fs = std::filesystem;

struct Parts {
    std::vector<std::string> code;  // lines of code blocks, with continuation lines joined
    std::string text;               // everything else
};

std::string trimmed(const std::string& line) {
    const auto first = line.find_first_not_of(" \t");
    return first == std::string::npos ? "" : line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
}

Parts parts_of(const std::string& page) {
    Parts parts;
    bool fenced = false, continued = false, after_blank = true;
    for (const std::string& line : lines_of(page)) {
        const std::string content = trimmed(line);
        if (content.starts_with("```")) {
            fenced = !fenced;
            after_blank = false;
            continue;
        }
        // Indented lines within a list or a sentence are not code.
        const bool indented = line.starts_with("    ") && after_blank;
        if (fenced || indented) {
            if (continued) {
                parts.code.back() += " " + content;
            } else {
                parts.code.push_back(content);
            }
            continued = content.ends_with('\\');
            if (continued) parts.code.back().pop_back();
        } else {
            parts.text += line + "\n";
            after_blank = content.empty();
        }
    }
    return parts;
}

// Text and the code between single backticks, which may continue on the next line.
struct Spans {
    std::vector<std::string> code;
    std::string text;
};

Spans spans_of(const std::string& text) {
    Spans spans;
    std::size_t at = 0;
    while (at < text.size()) {
        const auto begin = text.find('`', at);
        const auto end = begin == std::string::npos ? begin : text.find('`', begin + 1);
        if (end == std::string::npos) break;
        spans.text += text.substr(at, begin - at) + "``";
        std::string code = text.substr(begin + 1, end - begin - 1);
        std::replace(code.begin(), code.end(), '\n', ' ');
        spans.code.push_back(code);
        at = end + 1;
    }
    spans.text += text.substr(at);
    return spans;
}

// Words as a shell splits them, up to a comment or a control or redirection operator.
std::vector<std::string> words_of(const std::string& command) {
    std::vector<std::string> words;
    std::string word;
    bool begun = false;
    char quote = 0;
    const auto finish = [&] {
        if (begun) words.push_back(word);
        word.clear();
        begun = false;
    };
    for (const char c : command) {
        if (quote) {
            if (c == quote) {
                quote = 0;
            } else {
                word += c;
            }
        } else if (c == '\'' || c == '"') {
            quote = c;
            begun = true;
        } else if (c == ' ' || c == '\t') {
            finish();
        } else if (std::string_view(">|&;").find(c) != std::string_view::npos || (c == '#' && !begun)) {
            break;
        } else {
            word += c;
            begun = true;
        }
    }
    finish();
    return words;
}

void add_command(std::string line, std::vector<std::vector<std::string>>& commands) {
    for (const std::string_view prefix : {"- run: ", "run: ", "$ "}) {
        if (line.starts_with(prefix)) line.erase(0, prefix.size());
    }
    std::vector<std::string> words = words_of(line);
    if (words.empty() || (words[0] != "pushfactor" && words[0] != "build/release/pushfactor")) return;
    words.erase(words.begin());
    if (!words.empty()) commands.push_back(words);
}

}  // namespace

std::vector<std::vector<std::string>> commands_of(const std::string& page, bool in_sentences) {
    std::vector<std::vector<std::string>> commands;
    const Parts parts = parts_of(page);
    for (const std::string& line : parts.code) add_command(line, commands);
    if (in_sentences) {
        for (const std::string& code : spans_of(parts.text).code) {
            if (words_of(code).size() > 2) add_command(code, commands);  // "pushfactor scene" is a name
        }
    }
    return commands;
}

std::vector<std::string> links_of(const std::string& page) {
    std::vector<std::string> links;
    const std::string text = spans_of(parts_of(page).text).text;
    for (auto at = text.find("]("); at != std::string::npos; at = text.find("](", at + 2)) {
        const auto end = text.find(')', at);
        if (end == std::string::npos) break;
        const std::string target = text.substr(at + 2, end - at - 2);
        if (target.find("://") == std::string::npos && !target.starts_with("mailto:")) links.push_back(target);
    }
    return links;
}

std::set<std::string> anchors_of(const std::string& page) {
    std::set<std::string> anchors;
    std::map<std::string, int> count;
    for (const std::string& line : lines_of(parts_of(page).text)) {
        const auto level = line.find_first_not_of('#');
        if (level == 0 || level == std::string::npos || line[level] != ' ') continue;
        std::string anchor;
        for (const char c : trimmed(line.substr(level))) {
            if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_') {
                anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            } else if (c == ' ') {
                anchor += '-';
            }
        }
        const int earlier = count[anchor]++;
        anchors.insert(earlier == 0 ? anchor : anchor + "-" + std::to_string(earlier));
    }
    return anchors;
}

std::vector<std::string> link_faults(const std::string& root, const std::string& path, const std::string& page) {
    std::vector<std::string> faults;
    for (const std::string& link : links_of(page)) {
        const auto hash = link.find('#');
        const std::string file = link.substr(0, hash);
        const fs::path target = file.empty() ? fs::path(root) / path : (fs::path(root) / path).parent_path() / file;
        if (!file.empty() && !fs::exists(target)) {
            faults.push_back(path + ": " + file + " is not there");
        } else if (hash != std::string::npos) {
            const std::string text = file.empty() ? page : read_file(target);
            if (!anchors_of(text).contains(link.substr(hash + 1))) {
                faults.push_back(path + ": no heading is " + link);
            }
        }
    }
    return faults;
}

}  // namespace pushfactor::tests
