// Hash of a text, the same on every machine.
#pragma once

#include <cstdint>
#include <string_view>

namespace pushfactor::demos {

// FNV-1a, then the finaliser of splitmix64, so that every bit depends on every byte and remainders are even.
constexpr std::uint64_t text_hash(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3;
    }
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111eb;
    return hash ^ (hash >> 31);
}

}  // namespace pushfactor::demos
