// Texts in HTML and in addresses.
#pragma once

#include <string>
#include <string_view>

namespace pushfactor::demos::html {

std::string escaped(std::string_view text);  // also for double-quoted attributes

// An id: anything but letters, digits, '_', '-' and '.' becomes '-'.
std::string anchor(std::string_view name);

// URL of a file in the folder of the page.
std::string link_to(std::string_view file);

}  // namespace pushfactor::demos::html
