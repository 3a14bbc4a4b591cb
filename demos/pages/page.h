// A page of pictures with captions, tables and commands. It opens from disk and needs nothing from elsewhere.
#pragma once

#include "demos/pages/page_table.h"

#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos {

// What the page shows under one heading. Files lie in the folder of the page.
struct Plate {
    std::vector<std::string> pictures;  // PNG
    std::vector<std::string> files;     // what else there is of it: SVG, CSV
    std::string caption;                // settings and measured numbers
    std::vector<std::string> commands;  // that show the same with the program
    TextTable table{};
};

struct Section {
    std::string name;  // of the place on the page
    std::string heading;
    Plate plate;
};

// The page as one text, with style and script from assets/pages; numbers have four digits. Throws OutputError where
// these are missing.
std::string page_text(const std::string& title, const std::string& opening, std::span<const Section> sections);

}  // namespace pushfactor::demos
