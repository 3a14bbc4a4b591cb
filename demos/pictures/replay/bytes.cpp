#include "demos/pictures/replay/bytes.h"

#include "engine/base/index.h"

#include <algorithm>
#include <bit>
#include <cmath>

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

// The nearest whole number of units.
std::int64_t in_units(double value, double unit) {
    constexpr double most = 281474976710656.0;  // 2^48: the page counts in doubles
    return static_cast<std::int64_t>(std::nearbyint(std::clamp(value / unit, -most, most)));
}

constexpr int bits = 10;  // of the largest number of a Scaled

engine::Vector3 at_least(const engine::Vector3& vector, double least) {
    return vector.norm() < least ? engine::Vector3(engine::Vector3::Zero()) : vector;
}

// `last_exponent` is that of a vector without length.
Scaled scaled(const engine::Vector3& vector, std::int64_t last_exponent) {
    const double largest = vector.cwiseAbs().maxCoeff();
    if (!(largest > 0.0)) return {.exponent = last_exponent, .numbers = {}};
    const int exponent = std::ilogb(largest) + 1;
    const double unit = std::ldexp(1.0, exponent - bits);
    return {.exponent = exponent, .numbers = vector_in_units(vector, unit)};
}

void append_less(std::string& bytes, const Scaled& value, const Scaled& last) {
    append_integer(bytes, value.exponent - last.exponent);
    for (std::size_t i = 0; i < 3; ++i) append_integer(bytes, value.numbers[i] - last.numbers[i]);
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

void ForceBlock::add_who(const std::vector<Who>& who) {
    std::string& part = parts_[0];
    if (who == last_who_) {
        append_integer(part, 0);
        return;
    }
    append_integer(part, static_cast<std::int64_t>(who.size()) + 1);
    std::int64_t before = 0;
    for (const auto& [kind, body, other] : who) {
        append_integer(part, kind);
        append_integer(part, body - before);
        append_integer(part, other - body);
        before = body;
    }
    last_who_ = who;
}

void ForceBlock::add(std::span<const Acting> acting, double least_force, double least_push) {
    std::vector<Who> who;
    for (const Acting& at : acting) who.push_back({static_cast<std::int64_t>(at.kind), at.body, at.other});
    add_who(who);

    std::map<std::array<std::int64_t, 4>, Item> items;
    std::map<Who, std::int64_t> so_far;
    for (std::size_t i = 0; i < acting.size(); ++i) {
        const Acting& at = acting[i];
        const std::array key{who[i][0], who[i][1], who[i][2], so_far[who[i]]++};
        const auto found = last_.find(key);
        const Item last = found == last_.end() ? Item{} : found->second;
        Item& item = items[key];
        item.place = vector_in_units(at.place, position_units_[engine::at(at.body)]);
        for (std::size_t axis = 0; axis < 3; ++axis) append_integer(parts_[1], item.place[axis] - last.place[axis]);
        const std::array vectors{at_least(at.force, least_force), at_least(at.correcting, least_push),
                                 at_least(at.lasting, least_push)};
        for (std::size_t v = 0; v < vectors.size(); ++v) {
            item.vectors[v] = scaled(vectors[v], last.vectors[v].exponent);
            append_less(parts_[v == 0 ? 2 : 3], item.vectors[v], last.vectors[v]);
        }
    }
    last_ = std::move(items);
}

std::string ForceBlock::take() {
    std::string bytes;
    for (const std::string& part : parts_) append_integer(bytes, static_cast<std::int64_t>(part.size()));
    for (std::string& part : parts_) {
        bytes += part;
        part.clear();
    }
    last_who_.clear();
    last_.clear();
    return bytes;
}

}  // namespace pushfactor::demos::pictures::replay
