#include "demos/pictures/replay/bytes.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

namespace pushfactor::demos::pictures::replay {

namespace {

std::uint64_t with_sign_last(std::int64_t value) {
    const auto twice = static_cast<std::uint64_t>(value) << 1U;
    return value < 0 ? ~twice : twice;
}

// Of the polynomial of degree `degree` through the values before `at`.
std::int64_t foretold(std::span<const std::int64_t> values, std::size_t at, std::size_t degree) {
    if (at == 0) return 0;
    switch (std::min(degree, at - 1)) {
        case 0:
            return values[at - 1];
        case 1:
            return 2 * values[at - 1] - values[at - 2];
        default:
            return 3 * (values[at - 1] - values[at - 2]) + values[at - 3];
    }
}

}  // namespace

void append_integer(std::string& bytes, std::int64_t value) {
    std::uint64_t rest = with_sign_last(value);
    for (; rest >= 128; rest >>= 7U) bytes.push_back(static_cast<char>(128U | (rest & 127U)));
    bytes.push_back(static_cast<char>(rest));
}

void append_quantity(std::string& bytes, std::span<const std::int64_t> values) {
    if (std::ranges::all_of(values, [&](std::int64_t value) { return value == values.front(); })) {
        bytes.push_back('\0');
        append_integer(bytes, values.front());
        return;
    }
    std::array<long, 3> bits{};
    for (std::size_t degree = 0; degree < bits.size(); ++degree) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            bits[degree] += std::bit_width(with_sign_last(values[i] - foretold(values, i, degree)));
        }
    }
    const auto degree = static_cast<std::size_t>(std::ranges::min_element(bits) - bits.begin());
    bytes.push_back(static_cast<char>(degree + 1));
    for (std::size_t i = 0; i < values.size(); ++i) {
        append_integer(bytes, values[i] - foretold(values, i, degree));
    }
}

std::int64_t in_units(double value, double unit) {
    constexpr double most = 281474976710656.0;  // 2^48: the page counts in doubles
    return static_cast<std::int64_t>(std::nearbyint(std::clamp(value / unit, -most, most)));
}

std::array<std::int64_t, 3> vector_in_units(const engine::Vector3& vector, double unit) {
    return {in_units(vector.x(), unit), in_units(vector.y(), unit), in_units(vector.z(), unit)};
}

std::array<std::int64_t, 4> orientation_in_units(const engine::Quaternion& orientation,
                                                 const std::array<std::int64_t, 4>& last) {
    const std::array parts{orientation.w(), orientation.x(), orientation.y(), orientation.z()};
    double along = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) along += parts[i] * static_cast<double>(last[i]);
    std::array<std::int64_t, 4> units{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        units[i] = in_units(along < 0.0 ? -parts[i] : parts[i], orientation_unit);
    }
    return units;
}

namespace {

struct FreeCompressor {
    void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

}  // namespace

std::string deflated(std::string_view bytes) {
    constexpr int level = 9;  // 12 is three times as slow for two parts in a hundred
    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(libdeflate_alloc_compressor(level));
    if (!compressor) throw std::bad_alloc();
    std::string result(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
    result.resize(
        libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), result.data(), result.size()));
    return result;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto byte = [&](std::size_t i) -> std::uint32_t {
        return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U;
    };
    std::string text;
    text.reserve(4 * (bytes.size() / 3 + 1));
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::uint32_t three = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
        for (const unsigned shift : {18U, 12U, 6U, 0U}) text.push_back(digits[three >> shift & 63U]);
    }
    const std::size_t surplus = (3 - bytes.size() % 3) % 3;
    text.replace(text.size() - surplus, surplus, surplus, '=');
    return text;
}

}  // namespace pushfactor::demos::pictures::replay
