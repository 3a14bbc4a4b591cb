// Sequences of integers as few bytes that compress well. The page's decoder is assets/replay/decode.js.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace pushfactor::demos::pictures::replay {

// Appends an integer as a variable number of bytes, seven bits each, the lowest first; the sign is the lowest bit
// (0, -1, 1, -2, ... become 0, 1, 2, 3, ...).
void append_integer(std::string& bytes, std::int64_t value);

// Appends the values of one quantity in consecutive frames: a byte k, then
//
//   k = 0            the value, which all frames have
//   k = 1, 2 or 3    per frame the difference from the polynomial of degree k - 1 through the k values before (of a
//                    lower degree while there are fewer, and from 0 at first)
//
// with the k that needs the least bits. At least one value, each at most 2^48 in size.
void append_quantity(std::string& bytes, std::span<const std::int64_t> values);

// The nearest whole number of units, at most 2^48 in size.
std::int64_t in_units(double value, double unit);

}  // namespace pushfactor::demos::pictures::replay
