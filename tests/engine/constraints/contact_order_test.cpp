#include "engine/constraints/contact_order.h"

#include "tests/catch.h"
#include "tests/random.h"

#include <array>
#include <functional>

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
        for (const ContactIndex& c : contacts.put(by, touches, bodies, Vector3::UnitY())) {
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

namespace {

// The order of a layer of 100 cubes of this size side by side on the ground, with the given heights, all turned.
std::string order_of_layer(double size, double height, const std::function<double()>& jitter,
                           const Quaternion& turn = Quaternion::Identity(), bool gravity = true) {
    const Vector3 up = gravity ? Vector3(turn * Vector3::UnitY()) : Vector3(Vector3::Zero());
    std::vector<Body> bodies{static_body(Vector3::Zero())};
    std::vector<collision::Touch> touches;
    for (int i = 0; i < 100; ++i) {
        const Vector3 position(size * (i % 10), size * (height + jitter()), size * (i / 10));
        bodies.push_back(box_body(1, size * Vector3::Ones(), turn * position));
    }
    for (int i = 1; i <= 100; ++i) touches.push_back(Tower::touch(0, i));
    for (int i = 1; i < 100; ++i) {
        if (i % 10 != 0) touches.push_back(Tower::touch(i, i + 1));
    }
    for (collision::Touch& touch : touches) touch.size = size;
    ContactOrder contacts;
    std::string text;
    for (const ContactIndex& c : contacts.put(RowOrder::bottom_up, touches, bodies, up)) {
        text += std::to_string(c.touch) + " ";
    }
    return text;
}

}  // namespace

TEST_CASE("rounding does not decide the order of a layer: ground first, then pairs as they were made") {
    pushfactor::tests::Random random(74);
    const auto flat = [] { return 0.0; };
    const auto jittered = [&] { return random.in(-1e-12, 1e-12); };
    const std::string expected = order_of_layer(1.0, 0.5, flat);
    CHECK_THAT(expected, Catch::StartsWith("0 0 1 1 2 2 3 3"));
    for (const double size : {1.0, 0.2, 0.1, 3.0, 1e-3, 1000.0}) {
        for (const double height : {0.0, 0.5, 0.25, 0.1, 1.0, 1.5, 0.499, 0.498, 7.3, 1.0 / 3.0, 0.505}) {
            INFO(size << " " << height);
            CHECK(order_of_layer(size, height, jittered) == expected);
        }
    }
    // Heights in a resting layer differ by slop and tolerance; cubes a tenth higher are above it.
    CHECK(order_of_layer(1.0, 0.5, [&] { return random.in(-1e-3, 1e-3); }) == expected);
    CHECK(order_of_layer(1.0, 0.5, [&] { return random.in(-0.1, 0.1); }) != expected);
}

TEST_CASE("the order of rows turns with gravity, and without gravity it is that in which pairs were made") {
    pushfactor::tests::Random random(75);
    const auto uneven = [] {
        return [random = pushfactor::tests::Random(3)]() mutable { return random.in(-0.1, 0.1); };
    };
    const std::string expected = order_of_layer(1.0, 0.5, uneven());
    const std::string as_made = order_of_layer(1.0, 0.5, [] { return 0.0; });
    REQUIRE(expected != as_made);
    for (int i = 0; i < 20; ++i) {
        const Quaternion turn = random.rotation();
        CHECK(order_of_layer(1.0, 0.5, uneven(), turn) == expected);
        CHECK(order_of_layer(1.0, 0.5, uneven(), turn, false) == as_made);
    }
}
