#include "demos/reports/error/error.h"
#include "tests/catch.h"
#include "tests/random.h"

#include <algorithm>
#include <cmath>

using namespace pushfactor::demos::reports::error;

namespace {

bool beats(const WorkPoint& a, const WorkPoint& b) {
    return a.error <= b.error && a.work <= b.work && (a.error < b.error || a.work < b.work);
}

}  // namespace

TEST_CASE("the Pareto front is what nobody beats in both numbers, as brute force finds it") {
    pushfactor::tests::Random random(7);
    for (int round = 0; round < 200; ++round) {
        std::vector<WorkPoint> points;
        // Few different values, so that there are ties.
        for (int i = 0; i < 30; ++i) {
            const double error = std::floor(random.in(0, 12));
            points.push_back({.error = error, .work = std::floor(random.in(0, 12))});
        }
        const std::vector<std::size_t> front = pareto_front(points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool beaten = std::any_of(points.begin(), points.end(),
                                            [&](const WorkPoint& other) { return beats(other, points[i]); });
            const bool shown = std::any_of(front.begin(), front.end(), [&](std::size_t f) {
                return points[f].error == points[i].error && points[f].work == points[i].work;
            });
            CHECK(shown == !beaten);
        }
        for (std::size_t k = 1; k < front.size(); ++k) {
            CHECK(points[front[k - 1]].error < points[front[k]].error);
            CHECK(points[front[k - 1]].work > points[front[k]].work);
        }
    }
}

TEST_CASE("of nothing the front is nothing") {
    CHECK(pareto_front({}).empty());
}
