#include "demos/reports/error/pareto.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace pushfactor::demos::reports::error {

std::vector<std::size_t> pareto_front(std::span<const Trade> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [points](std::size_t a, std::size_t b) {
        return std::tuple(points[a].error, points[a].work, a) < std::tuple(points[b].error, points[b].work, b);
    });
    // With the error rising, a point is on the front when it takes less work than all before it.
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        if (front.empty() || points[i].work < points[front.back()].work) front.push_back(i);
    }
    return front;
}

}  // namespace pushfactor::demos::reports::error
