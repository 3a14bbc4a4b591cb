#include "demos/reports/error/error.h"
#include "tests/catch.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor::demos::reports::error;

TEST_CASE("labels lie inside, beside their points, and never one on the other") {
    pushfactor::tests::Random random(3);
    std::vector<Place> points;
    std::vector<std::string> labels;
    for (int i = 0; i < 60; ++i) {
        const double x = random.in(0, 100);
        points.emplace_back(x, random.in(0, 70));
        labels.emplace_back("1/240");
    }
    const auto places = place_labels(points, labels, {}, {100, 70});
    int placed = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i]) continue;
        ++placed;
        CHECK(places[i]->x() >= 2.5);
        CHECK(places[i]->x() <= 97.5);
        CHECK(std::hypot(places[i]->x() - points[i].x(), places[i]->y() - points[i].y()) < 5.0);
        for (std::size_t k = 0; k < i; ++k) {
            if (!places[k]) continue;
            const bool apart = std::abs(places[i]->x() - places[k]->x()) >= 5.0 - 1e-9 ||
                               std::abs(places[i]->y() - places[k]->y()) >= 1.9 - 1e-9;
            CHECK(apart);
        }
    }
    CHECK(placed > 40);
}

TEST_CASE("a label keeps off a line where there is room") {
    const std::vector<Segment> line{{{50, 50}, {90, 50}}};
    const auto places = place_labels({{50, 50}}, {"25"}, line, {100, 100});
    REQUIRE(places[0]);
    CHECK(places[0]->x() < 50.0);
}

TEST_CASE("where there is no room there is no label") {
    CHECK(!place_labels({{1, 1}}, {"a long label"}, {}, {4, 4})[0]);
}
