// HTML fragments, and links to the page that runs the program in a browser (assets/live).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos::html {

std::string escaped(std::string_view text);  // also for double-quoted attributes

// An id: anything but letters, digits, '_', '-' and '.' becomes '-'.
std::string anchor(std::string_view name);

// URL of a file in the folder of the page.
std::string link_to(std::string_view file);

// The page that runs the program, beside those that link to it, where it has been made.
inline constexpr const char* name_of_live_page = "live.html";

struct LiveLink {
    std::string address;  // of the page beside the one that links to it
    std::string differs;  // "push none" of --compare; empty for a single run
};

// Where the page shows what the command does at its end or at its last instant: a run or rendering of a scene of
// the catalogue, one link per value that it compares. None for other commands.
std::vector<LiveLink> live_links(std::string_view command);

// A command with a copy button, and with its links to that page. `what` describes the command to screen readers.
std::string command(std::string_view command, std::string_view what);

}  // namespace pushfactor::demos::html
