#include "renderer/base/utf8.h"

namespace pushfactor::renderer {
namespace {

constexpr char32_t replacement = 0xFFFD;

// What a first byte announces. The second byte's range is narrower than that of the others where more would be
// an overlong form, a surrogate or beyond U+10FFFF.
struct Sequence {
    int more;             // bytes that follow
    char32_t bits;        // of the first byte
    unsigned low = 0x80;  // of the second byte
    unsigned high = 0xBF;
};

Sequence announced_by(unsigned first) {
    if (first < 0x80) return {0, first};
    if (first >= 0xC2 && first <= 0xDF) return {1, first & 0x1Fu};
    if (first >= 0xE0 && first <= 0xEF) {
        return {2, first & 0x0Fu, first == 0xE0 ? 0xA0u : 0x80u, first == 0xED ? 0x9Fu : 0xBFu};
    }
    if (first >= 0xF0 && first <= 0xF4) {
        return {3, first & 0x07u, first == 0xF0 ? 0x90u : 0x80u, first == 0xF4 ? 0x8Fu : 0xBFu};
    }
    return {0, replacement};
}

unsigned take_byte(std::string_view& bytes) {
    const auto byte = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    return byte;
}

}  // namespace

char32_t take_character(std::string_view& utf8) {
    Sequence sequence = announced_by(take_byte(utf8));
    char32_t character = sequence.bits;
    for (int i = 0; i < sequence.more; ++i) {
        if (utf8.empty()) return replacement;
        const auto next = static_cast<unsigned char>(utf8.front());
        if (next < sequence.low || next > sequence.high) return replacement;
        character = (character << 6) | (take_byte(utf8) & 0x3Fu);
        sequence.low = 0x80;
        sequence.high = 0xBF;
    }
    return character;
}

}  // namespace pushfactor::renderer
