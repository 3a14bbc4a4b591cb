// Texts as HTML.
#pragma once

#include <string>
#include <string_view>

namespace pushfactor::demos::html {

std::string escaped(std::string_view text);  // also within double quotes

// What may be an id: anything but letters, digits, '_', '-' and '.' becomes '-'.
std::string anchor(std::string_view name);

// Of a file in the folder of the page.
std::string link_to(std::string_view file);

// A command with the button that copies it. `what` says which command it is to those who hear the page.
std::string command(std::string_view command, std::string_view what);

}  // namespace pushfactor::demos::html
