// A self-contained page of pictures with captions, tables and commands; it opens from disk.
#pragma once

#include "demos/pages/table.h"

#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos {

// Content under one heading. Files are in the folder of the page.
struct SectionContent {
    std::vector<std::string> pictures{};  // PNG
    std::vector<std::string> files{};     // other formats: SVG, CSV
    std::vector<std::string> replays{};   // HTML, opened by their names
    std::string caption{};                // settings and measured numbers
    std::vector<std::string> commands{};  // that reproduce it with the program
    TextTable table{};
    std::string kept{};  // HTML of the whole section on an earlier page, instead of all this
};

struct Section {
    std::string name;  // of the anchor
    std::string heading;
    SectionContent content{};
};

// The HTML text of a page with the styles and scripts of these names in assets/pages, in that order. `opening` is
// text, `body` HTML. Throws OutputError if an asset is missing.
std::string document(const std::string& title, const std::string& opening, const std::string& body,
                     std::initializer_list<const char*> assets);

// The HTML of a section on a page that page_text() made; empty if it has none of that name.
std::string section_on(const std::string& page, const std::string& name);

// The HTML text, with style and script from assets/pages; numbers have four digits. Throws OutputError if these are
// missing.
std::string page_text(const std::string& title, const std::string& opening, std::span<const Section> sections);

// Writes FOLDER/index.html, and beside it the page that it links to. Throws OutputError.
void write_index(const std::filesystem::path& folder, const std::string& page);

}  // namespace pushfactor::demos
