#include "engine/row_order.h"

#include "tests/catch.h"

#include <array>

using namespace pushfactor::engine;

namespace {

// Ground, and three cubes of which the first made is the highest.
struct Tower {
    std::vector<Body> bodies{static_body(Vector3::Zero()), box_body(1, Vector3::Ones(), {0, 2.5, 0}),
                             box_body(1, Vector3::Ones(), {0, 1.5, 0}), box_body(1, Vector3::Ones(), {0, 0.5, 0})};
    std::vector<collision::Touch> touches{touch(0, 3), touch(1, 2), touch(2, 3)};

    static collision::Touch touch(int a, int b) {
        collision::Touch result;
        result.pair = {a, b};
        result.body_a = a;
        result.body_b = b;
        static const std::array<collision::ContactPoint, 2> points{};
        result.points = points;
        return result;
    }

    // "0a 0b 2a ..." : touch and point.
    std::string order(RowOrder by) const {
        ContactOrder contacts;
        std::string text;
        for (const ContactIndex& c : contacts.put(by, touches, bodies)) {
            text += std::to_string(c.touch) + (c.point == 0 ? "a " : "b ");
        }
        return text;
    }
};

}  // namespace

TEST_CASE("the row orders are what their names say") {
    const Tower tower;
    CHECK(tower.order(RowOrder::creation) == "0a 0b 1a 1b 2a 2b ");
    CHECK(tower.order(RowOrder::reverse) == "2b 2a 1b 1a 0b 0a ");
    CHECK(tower.order(RowOrder::bottom_up) == "0a 0b 2a 2b 1a 1b ");
    CHECK(tower.order(RowOrder::normals_first) == tower.order(RowOrder::bottom_up));
}
