// Bytes as a page can hold them.
#pragma once

#include <string>
#include <string_view>

namespace pushfactor::demos::pictures::replay {

// Compressed as a zlib stream (RFC 1950), which browsers inflate by themselves (DecompressionStream "deflate").
std::string deflated(std::string_view bytes);

// RFC 4648, section 4.
std::string base64(std::string_view bytes);

// Appends a number's own bytes, lowest first on all machines that we build for.
template <typename Number>
void append_raw(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

}  // namespace pushfactor::demos::pictures::replay
