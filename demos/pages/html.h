// HTML fragments.
#pragma once

#include <string>
#include <string_view>

namespace pushfactor::demos::html {

std::string escaped(std::string_view text);  // also for double-quoted attributes

// An id: anything but letters, digits, '_', '-' and '.' becomes '-'.
std::string anchor(std::string_view name);

// URL of a file in the folder of the page.
std::string link_to(std::string_view file);

// A command with a copy button, and with links to the page that runs it where there is one (live_links.h). `what`
// describes the command to screen readers.
std::string command(std::string_view command, std::string_view what);

}  // namespace pushfactor::demos::html
