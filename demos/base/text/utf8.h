// Texts of others, such as names of files, as UTF-8.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace pushfactor::demos {

// Length of the UTF-8 character at the beginning of `text`; 0 where there is none. Its code point goes to `code`.
inline std::size_t character_at(std::string_view text, std::uint32_t& code) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (text.empty()) return 0;
    const std::size_t length = byte(0) < 0x80       ? 1
                               : byte(0) >> 5 == 6  ? 2
                               : byte(0) >> 4 == 14 ? 3
                               : byte(0) >> 3 == 30 ? 4
                                                    : 0;
    if (length == 0 || text.size() < length) return 0;
    code = length == 1 ? byte(0) : byte(0) & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if (byte(i) >> 6 != 2) return 0;
        code = code << 6 | (byte(i) & 0x3fu);
    }
    constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xd800 && code <= 0xdfff;
    return code < least[length] || code > 0x10ffff || surrogate ? 0 : length;
}

// The text with U+FFFD for every byte that is no UTF-8, and for every character that is not `allowed`.
template <typename Allowed>
std::string utf8(std::string_view text, const Allowed& allowed) {
    std::string result;
    while (!text.empty()) {
        std::uint32_t code = 0;
        const std::size_t length = character_at(text, code);
        if (length > 0 && allowed(code)) {
            result += text.substr(0, length);
        } else {
            result += "\xef\xbf\xbd";
        }
        text.remove_prefix(length > 0 ? length : 1);
    }
    return result;
}

inline std::string utf8(std::string_view text) {
    return utf8(text, [](std::uint32_t) { return true; });
}

}  // namespace pushfactor::demos
