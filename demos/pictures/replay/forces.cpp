#include "demos/pictures/replay/forces.h"

#include "demos/pictures/replay/bytes.h"

#include <cmath>

namespace pushfactor::demos::pictures::replay {

namespace {

constexpr int bits = 10;  // of the largest number of a Scaled

engine::Vector3 at_least(const engine::Vector3& vector, double least) {
    return vector.norm() < least ? engine::Vector3(engine::Vector3::Zero()) : vector;
}

void append_less(std::string& bytes, const Scaled& value, const Scaled& last) {
    append_integer(bytes, value.exponent - last.exponent);
    for (std::size_t i = 0; i < 3; ++i) append_integer(bytes, value.numbers[i] - last.numbers[i]);
}

}  // namespace

Scaled scaled(const engine::Vector3& vector, std::int64_t last_exponent) {
    const double largest = vector.cwiseAbs().maxCoeff();
    if (!(largest > 0.0)) return {.exponent = last_exponent, .numbers = {}};
    const int exponent = std::ilogb(largest) + 1;
    const double unit = std::ldexp(1.0, exponent - bits);
    return {.exponent = exponent, .numbers = vector_in_units(vector, unit)};
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
        item.place = vector_in_units(at.place, position_units_[static_cast<std::size_t>(at.body)]);
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
