#include "tests/demos/replay/decoder.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pushfactor::tests {

namespace {

// As read: place, then exponent and three numbers of each vector.
struct RawItem {
    std::array<std::int64_t, 3> who{};
    std::array<std::int64_t, 15> numbers{};
};

// The item of the frame before that an item is stored against: the n-th of the same kind and bodies.
const RawItem* partner_of(const std::vector<RawItem>& items, std::size_t index,
                          const std::vector<RawItem>& before) {
    const auto& who = items[index].who;
    const auto is_like = [&](const RawItem& item) { return item.who == who; };
    auto skipped = std::count_if(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(index), is_like);
    for (const RawItem& item : before) {
        if (is_like(item) && skipped-- == 0) return &item;
    }
    return nullptr;
}

ReadItem meaning_of(const RawItem& raw) {
    ReadItem item{.kind = raw.who[0], .body = raw.who[1], .other = raw.who[2], .place = {}, .vectors = {}};
    std::copy_n(raw.numbers.begin(), 3, item.place.begin());
    for (std::size_t v = 0; v < 3; ++v) {
        for (std::size_t k = 0; k < 3; ++k) {
            item.vectors[v][k] = std::ldexp(static_cast<double>(raw.numbers[3 + 4 * v + 1 + k]),
                                            static_cast<int>(raw.numbers[3 + 4 * v]) - 10);
        }
    }
    return item;
}

}  // namespace

std::int64_t IntegerReader::next() {
    std::uint64_t value = 0;
    for (unsigned shift = 0;; shift += 7) {
        const std::uint64_t part = byte();
        value |= (part & 127U) << shift;
        if (part < 128) break;
    }
    const auto half = static_cast<std::int64_t>(value >> 1U);
    return (value & 1U) != 0 ? -half - 1 : half;
}

std::vector<std::vector<std::int64_t>> read_quantities(const std::string& bytes, std::size_t count,
                                                       std::size_t frames) {
    IntegerReader reader(bytes);
    std::vector<std::vector<std::int64_t>> all;
    for (std::size_t quantity = 0; quantity < count; ++quantity) {
        const int kind = reader.byte();
        if (kind == 0) {
            all.emplace_back(frames, reader.next());
            continue;
        }
        // Repeated sums of the differences: those of the k-th order are stored.
        std::vector<std::int64_t>& values = all.emplace_back();
        for (std::size_t i = 0; i < frames; ++i) {
            const std::size_t order = std::min<std::size_t>(static_cast<std::size_t>(kind), i);
            constexpr std::array<std::array<std::int64_t, 3>, 4> weights{
                {{0, 0, 0}, {1, 0, 0}, {2, -1, 0}, {3, -3, 1}}};
            std::int64_t value = reader.next();
            for (std::size_t k = 0; k < order; ++k) value += weights[order][k] * values[i - 1 - k];
            values.push_back(value);
        }
    }
    if (!reader.is_at_end()) throw std::runtime_error("bytes are left");
    return all;
}

std::vector<std::vector<ReadItem>> read_forces(const std::string& bytes, std::size_t frames) {
    IntegerReader head(bytes);
    std::array<std::size_t, 4> lengths{};
    for (std::size_t& length : lengths) length = static_cast<std::size_t>(head.next());
    std::string rest = head.rest();
    std::vector<IntegerReader> parts;
    for (const std::size_t length : lengths) {
        parts.emplace_back(rest.substr(0, length));
        rest.erase(0, length);
    }
    if (!rest.empty()) throw std::runtime_error("bytes are left");
    std::vector<std::vector<ReadItem>> lists;
    std::vector<RawItem> before;
    for (std::size_t frame = 0; frame < frames; ++frame) {
        std::vector<RawItem> items;
        const std::int64_t length = parts[0].next();
        if (length == 0) {
            for (const RawItem& item : before) items.push_back({.who = item.who, .numbers = {}});
        }
        std::int64_t body = 0;
        for (std::int64_t i = 1; i < length; ++i) {
            const std::int64_t kind = parts[0].next();
            body += parts[0].next();
            items.push_back({.who = {kind, body, body + parts[0].next()}, .numbers = {}});
        }
        std::vector<ReadItem>& list = lists.emplace_back();
        for (std::size_t i = 0; i < items.size(); ++i) {
            const RawItem* const partner = partner_of(items, i, before);
            for (std::size_t k = 0; k < 15; ++k) {
                items[i].numbers[k] = parts[k < 3 ? 1 : k < 7 ? 2 : 3].next() + (partner ? partner->numbers[k] : 0);
            }
            list.push_back(meaning_of(items[i]));
        }
        before = items;
    }
    for (const IntegerReader& part : parts) {
        if (!part.is_at_end()) throw std::runtime_error("bytes are left");
    }
    return lists;
}

}  // namespace pushfactor::tests
