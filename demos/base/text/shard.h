// Shares of a work that many processes do together: "3/8" is the third of eight.
#pragma once

#include "demos/base/text/numbers.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pushfactor::demos {

struct Shard {
    int number = 1;  // from 1 to count
    int count = 1;

    bool operator==(const Shard&) const = default;

    // Whether this share has the piece of work with this number; each number is in exactly one of `count`.
    bool takes(std::uint64_t piece) const {
        return piece % static_cast<std::uint64_t>(count) == static_cast<std::uint64_t>(number - 1);
    }
};

// None if the text is not K/N with 1 <= K <= N <= 1000000.
inline std::optional<Shard> parse_shard(std::string_view text) {
    const auto slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto number = parse_integer(text.substr(0, slash)), count = parse_integer(text.substr(slash + 1));
    if (!number || !count || *number < 1 || *count < *number || *count > 1000000) return std::nullopt;
    return Shard{*number, *count};
}

inline std::string to_text(const Shard& shard) {
    return std::to_string(shard.number) + "/" + std::to_string(shard.count);
}

}  // namespace pushfactor::demos
