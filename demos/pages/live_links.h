// Links from commands to the page that runs the program in a browser (assets/live), where that page has been made.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

struct LiveLink {
    std::string address;  // of the page beside the one that links to it
    std::string differs;  // "push none" of --compare; empty for a single run
};

// Where the page shows what the command does at its end or at its last instant: a run or rendering of a scene of
// the catalogue, one link per value that it compares. None for other commands.
std::vector<LiveLink> live_links(std::string_view command);

// Writes FOLDER/index.html, and beside it the page that it links to. Throws OutputError.
void write_index(const std::filesystem::path& folder, const std::string& page);

}  // namespace pushfactor::demos
