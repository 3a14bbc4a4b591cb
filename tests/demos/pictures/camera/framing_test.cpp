#include "demos/pictures/camera/framing.h"

#include "tests/catch.h"
#include "tests/random.h"

#include <cmath>
#include <numbers>

using namespace pushfactor::demos;
using namespace pushfactor::demos::pictures;
using pushfactor::engine::Vector3;

namespace {

// From the middle of the picture, as shares of half of it.
struct Reach {
    double across = 0.0, up = 0.0;
};

std::vector<Ball> random_balls(int count) {
    pushfactor::tests::Random random(7);
    std::vector<Ball> balls;
    for (int i = 0; i < count; ++i) {
        balls.push_back(
            {.centre = {random.in(-6, 9), random.in(0, 20), random.in(-3, 3)}, .radius = random.in(0.1, 2)});
    }
    return balls;
}

// The largest |x| and |y| of the balls' outlines in the picture, 1 at its edges; brute force over directions.
Reach outline(const View& view, const std::vector<Ball>& balls, double aspect) {
    Reach most;
    for (const Ball& ball : balls) {
        for (int i = 0; i < 2000; ++i) {
            const double z = 1.0 - 2.0 * (i + 0.5) / 2000.0;
            const double turn = i * 2.399963;
            const double side = std::sqrt(1.0 - z * z);
            const Vector3 point =
                ball.centre + ball.radius * Vector3(side * std::cos(turn), z, side * std::sin(turn));
            const Eigen::Vector2d place = place_in_picture(point, view, aspect);
            most.across = std::max(most.across, std::abs(2.0 * place.x() - 1.0));
            most.up = std::max(most.up, std::abs(2.0 * place.y() - 1.0));
        }
    }
    return most;
}

}  // namespace

TEST_CASE("a fitted camera shows all balls, and one of the picture's sides is just used") {
    const View view{.eye = {9, 8, 30}, .target = {0, 5, 0}};
    for (const double aspect : {0.5, 1.0, 16.0 / 9.0}) {
        const std::vector<Ball> balls = random_balls(12);
        const View fit = fitted(view, balls, aspect);
        const Reach seen = outline(fit, balls, aspect);
        CHECK(std::max(seen.across, seen.up) < 0.901);
        CHECK(std::max(seen.across, seen.up) > 0.88);
        CHECK((fit.target - fit.eye).normalized().dot((view.target - view.eye).normalized()) == Approx(1.0));
    }
}

TEST_CASE("a single ball is seen from outside of it, however near that would have to be") {
    const View fit = fitted(View{}, std::vector<Ball>{{.centre = {1, 2, 3}, .radius = 5.0}}, 1.0);
    CHECK((fit.eye - Vector3(1, 2, 3)).norm() > 5.0);
}

TEST_CASE("the middle of the picture is where the camera looks, and its corners are where the angles say") {
    const View view{.eye = {0, 0, 10}, .target = {0, 0, 0}, .field_of_view = 90.0};
    const Eigen::Vector2d middle = place_in_picture({0, 0, 0}, view, 2.0);
    CHECK(middle.x() == Approx(0.5));
    CHECK(middle.y() == Approx(0.5));
    const Eigen::Vector2d corner = place_in_picture({20, 10, 0}, view, 2.0);
    CHECK(corner.x() == Approx(1.0));
    CHECK(corner.y() == Approx(0.0).margin(1e-12));
}

TEST_CASE("a view is widened until it shows what it must, and never narrowed") {
    const View view{.eye = {0, 0, 10}, .target = {0, 0, 0}, .field_of_view = 40.0};
    const auto half = [](const View& v) { return std::tan(0.5 * v.field_of_view * std::numbers::pi / 180.0); };
    CHECK(widened(view, 0.01, 1.0).field_of_view == 40.0);
    CHECK(0.9 * half(widened(view, 0.8, 1.0)) == Approx(0.8));
    CHECK(0.9 * half(widened(view, 0.4, 0.5)) * 0.5 == Approx(0.4));
}
