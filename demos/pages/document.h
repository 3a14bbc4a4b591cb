// The frame of a page: head, style, heading, script.
#pragma once

#include <span>
#include <string>

namespace pushfactor::demos {

// The HTML text of a page with the styles and scripts of these names in assets/pages, in that order. `opening` is
// text, `body` HTML. Throws OutputError if an asset is missing.
std::string document(const std::string& title, const std::string& opening, const std::string& body,
                     std::span<const std::string> assets);

}  // namespace pushfactor::demos
