#include "engine/constraints/contact_order.h"

#include "engine/base/constants.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

double rounded(double height, double size) {
    const double quantum = size / constants::rows::quanta_a_size;
    if (!(quantum > 0.0) || !std::isfinite(size)) return height;
    return quantum * std::floor(height / quantum + (1.0 - constants::rows::rounds_up_at));
}

double height_of(const collision::Touch& touch, std::span<const Body> bodies, const Vector3& up) {
    double lowest = infinity;
    for (const int index : {touch.body_a, touch.body_b}) {
        const Body& body = bodies[static_cast<std::size_t>(index)];
        if (!body.is_static()) lowest = std::min(lowest, up.dot(body.position));
    }
    return rounded(lowest, touch.size);
}

// At equal height pairs with a static body come first: it is below what stands on it.
bool rests_on_static(const collision::Touch& touch, std::span<const Body> bodies) {
    return bodies[static_cast<std::size_t>(touch.body_a)].is_static() ||
           bodies[static_cast<std::size_t>(touch.body_b)].is_static();
}

}  // namespace

bool ContactOrder::before(const Key& a, const Key& b) {
    if (a.height != b.height) return a.height < b.height;
    return a.on_movable != b.on_movable ? b.on_movable : a.touch < b.touch;
}

std::span<const ContactIndex> ContactOrder::put(RowOrder order, std::span<const collision::Touch> touches,
                                                std::span<const Body> bodies, const Vector3& up) {
    const bool by_height = order == RowOrder::bottom_up || order == RowOrder::normals_first;
    // Start from the order of the last call, which changes little while bodies rest.
    if (keys_.size() != touches.size()) {
        keys_.resize(touches.size());
        for (std::size_t i = 0; i < keys_.size(); ++i) keys_[i].touch = static_cast<int>(i);
    }
    for (Key& key : keys_) {
        const collision::Touch& touch = touches[static_cast<std::size_t>(key.touch)];
        key.height = by_height ? height_of(touch, bodies, up) : 0.0;
        key.on_movable = by_height && !rests_on_static(touch, bodies);
    }
    if (!std::is_sorted(keys_.begin(), keys_.end(), before)) std::sort(keys_.begin(), keys_.end(), before);

    contacts_.clear();
    for (const Key& key : keys_) {
        const auto points = static_cast<int>(touches[static_cast<std::size_t>(key.touch)].points.size());
        for (int p = 0; p < points; ++p) contacts_.push_back({key.touch, p});
    }
    if (order == RowOrder::reverse) std::reverse(contacts_.begin(), contacts_.end());
    return contacts_;
}

}  // namespace pushfactor::engine
