// Words of a command line as a shell takes them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

// The word, in quotes where a shell would not take it as it is.
inline std::string quoted(const std::string& word) {
    const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=,:+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

// "pushfactor run stack": the program with these words.
inline std::string command_of(std::span<const std::string> words) {
    std::string text = "pushfactor";
    for (const std::string& word : words) text += " " + quoted(word);
    return text;
}

// The words of such a command.
inline std::vector<std::string> words_of(std::string_view command) {
    std::vector<std::string> words;
    bool in_word = false, in_quotes = false;
    for (std::size_t i = 0; i < command.size(); ++i) {
        const char c = command[i];
        if (!in_quotes && c == ' ') {
            in_word = false;
            continue;
        }
        if (!in_word) words.emplace_back();
        in_word = true;
        if (c == '\'') {
            in_quotes = !in_quotes;
        } else if (!in_quotes && c == '\\' && i + 1 < command.size()) {
            words.back() += command[++i];
        } else {
            words.back() += c;
        }
    }
    return words;
}

}  // namespace pushfactor::demos
