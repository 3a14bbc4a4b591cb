#pragma once

#include <string_view>

namespace pushfactor::renderer {

// Takes the next character from the front of non-empty UTF-8 text. Each longest invalid prefix gives one U+FFFD, as
// Unicode recommends; at least one byte is always consumed.
char32_t take_character(std::string_view& utf8);

}  // namespace pushfactor::renderer
