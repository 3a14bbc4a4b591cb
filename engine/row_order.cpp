#include "engine/row_order.h"

#include <algorithm>

namespace pushfactor::engine {

namespace {

double height_of(const collision::Touch& touch, std::span<const Body> bodies) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const int index : {touch.body_a, touch.body_b}) {
        const Body& body = bodies[static_cast<std::size_t>(index)];
        if (!body.is_static()) lowest = std::min(lowest, body.position.y());
    }
    return lowest;
}

// A static partner is below whatever stands on it, so at equal height its pair comes first.
bool rests_on_static(const collision::Touch& touch, std::span<const Body> bodies) {
    return bodies[static_cast<std::size_t>(touch.body_a)].is_static() ||
           bodies[static_cast<std::size_t>(touch.body_b)].is_static();
}

}  // namespace

void order_contacts(RowOrder order, std::span<const collision::Touch> touches, std::span<const Body> bodies,
                    std::vector<ContactIndex>& contacts) {
    const bool by_height = order == RowOrder::bottom_up || order == RowOrder::normals_first;
    std::vector<std::tuple<double, bool, int>> keys;
    for (int t = 0; t < static_cast<int>(touches.size()); ++t) {
        const collision::Touch& touch = touches[static_cast<std::size_t>(t)];
        keys.emplace_back(by_height ? height_of(touch, bodies) : 0.0, by_height && !rests_on_static(touch, bodies),
                          t);
    }
    if (by_height) std::sort(keys.begin(), keys.end());

    contacts.clear();
    for (const auto& [height, on_movable, t] : keys) {
        for (int p = 0; p < touches[static_cast<std::size_t>(t)].manifold.count; ++p) contacts.push_back({t, p});
    }
    if (order == RowOrder::reverse) std::reverse(contacts.begin(), contacts.end());
}

}  // namespace pushfactor::engine
