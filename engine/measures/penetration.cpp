#include "engine/measures/penetration.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

Penetration penetration(std::span<const Body> bodies, std::span<const collision::Collider> colliders) {
    collision::Detector detector;
    return penetration(bodies, colliders, detector);
}

Penetration penetration(std::span<const Body> bodies, std::span<const collision::Collider> colliders,
                        collision::Detector& detector, Threads* threads) {
    const Awake all_colliders(colliders.size()), all_bodies(bodies.size());
    Penetration result;
    double sum_of_squares = 0.0;
    for (const collision::Touch& touch :
         detector.detect(colliders, bodies, {.margin = 0.0, .reduce_to_four_points = false}, nullptr,
                         {all_colliders, all_colliders.members(), all_bodies.members()}, threads)) {
        double deepest = 0.0;
        for (const collision::ContactPoint& point : touch.points) {
            deepest = std::max(deepest, -point.gap);
            sum_of_squares += point.gap * point.gap;
            ++result.points;
        }
        result.max = std::max(result.max, deepest);
        if (deepest > Penetration::listed * touch.size) result.deep.push_back({touch.pair, deepest / touch.size});
    }
    if (result.points > 0) result.rms = std::sqrt(sum_of_squares / result.points);
    return result;
}

double deepening(const Penetration& from, const Penetration& to) {
    double largest = 0.0;
    auto before = from.deep.begin();
    for (const Penetration::Pair& now : to.deep) {
        while (before != from.deep.end() && before->colliders < now.colliders) ++before;
        const bool is_known = before != from.deep.end() && before->colliders == now.colliders;
        largest = std::max(largest, now.share - (is_known ? before->share : 0.0));
    }
    return largest;
}

}  // namespace pushfactor::engine
