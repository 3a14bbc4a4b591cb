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
    contacts.clear();
    for (int t = 0; t < static_cast<int>(touches.size()); ++t) {
        for (int p = 0; p < touches[static_cast<std::size_t>(t)].manifold.count; ++p) contacts.push_back({t, p});
    }
    if (order == RowOrder::reverse) std::reverse(contacts.begin(), contacts.end());
    if (order == RowOrder::reverse || order == RowOrder::creation) return;

    const auto key = [&](const ContactIndex& contact) {
        const collision::Touch& touch = touches[static_cast<std::size_t>(contact.touch)];
        return std::tuple(height_of(touch, bodies), !rests_on_static(touch, bodies), contact.touch, contact.point);
    };
    std::sort(contacts.begin(), contacts.end(),
              [&](const ContactIndex& p, const ContactIndex& q) { return key(p) < key(q); });
}

}  // namespace pushfactor::engine
