#pragma once

#include <string_view>

namespace pushfactor::renderer {

// Takes the next character from the front of UTF-8 text that is not empty. Bytes that are no character give
// U+FFFD once for each longest beginning of one, as Unicode recommends; at least one byte is always taken.
char32_t take_character(std::string_view& utf8);

}  // namespace pushfactor::renderer
