// Words of a command line as a shell takes them.
#pragma once

#include <span>
#include <string>

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

}  // namespace pushfactor::demos
