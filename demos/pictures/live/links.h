// Links from commands to the page that runs the program in a browser.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos::pictures::live {

struct PageLink {
    std::string address;  // of the page beside the one that links to it
    std::string differs;  // "push none" of --compare; empty for a single run
};

// Where the page shows what the command does at its end or at its last instant: a run or rendering of a scene of
// the catalogue, one link per value that it compares. None for other commands.
std::vector<PageLink> page_links(std::string_view command);

}  // namespace pushfactor::demos::pictures::live
