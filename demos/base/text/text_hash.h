// Hash of a text, the same on every machine.
#pragma once

#include <cstdint>
#include <string_view>

namespace pushfactor::demos {

// FNV-1a; `hash` is that of the text before.
constexpr std::uint64_t fnv_hash(std::string_view text, std::uint64_t hash = 0xcbf29ce484222325) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return hash;
}

// The finaliser of splitmix64: every bit depends on every bit.
constexpr std::uint64_t mixed_bits(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    return bits ^ (bits >> 31);
}

// Even remainders.
constexpr std::uint64_t text_hash(std::string_view text) {
    return mixed_bits(fnv_hash(text));
}

}  // namespace pushfactor::demos
