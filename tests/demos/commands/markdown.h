// The commands, links and heading anchors of a Markdown page. Pure functions of the text.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::tests {

// The commands that call `pushfactor` or `build/release/pushfactor`, as words without the program's name: lines of
// code blocks, fenced or indented, and, where `in_sentences`, code between backticks of more than two words.
// Comments, redirections and everything after them are left out.
std::vector<std::vector<std::string>> commands_of(const std::string& page, bool in_sentences);

// Targets of links and pictures outside code, without those of other hosts.
std::vector<std::string> links_of(const std::string& page);

// The anchors of all headings, as GitHub makes them: "Two words" is "two-words", the second one of the same name
// "two-words-1".
std::set<std::string> anchors_of(const std::string& page);

// The broken links of a page: "engine/README.md: b.md is not there". `path` is the page's, in `root`.
std::vector<std::string> link_faults(const std::string& root, const std::string& path, const std::string& page);

}  // namespace pushfactor::tests
