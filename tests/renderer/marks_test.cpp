#include "renderer/picture/marks.h"

#include "renderer/renderer.h"
#include "tests/catch.h"
#include "tests/renderer/sample_pictures.h"

#include <utility>

using namespace pushfactor::renderer;

namespace {

constexpr int width = 320;   // pixels
constexpr int height = 180;  // pixels

// The colour of a picture's points that are given in the frame of `from_the_front`.
Pixel colour_at(const Image& image, const glm::vec3& point) {
    const auto [x, y] = pixel_from_the_front(image.width, image.height, point);
    return image.pixel(x, y);
}

// Without GL: the marks alone, over one colour.
Image marks_on(const Image& ground, const Picture& picture) {
    Image image = ground;
    draw_marks(image, picture);
    return image;
}

Image plain(std::uint8_t level) {
    return {width, height, std::vector<std::uint8_t>(std::size_t{3} * width * height, level)};
}

int pixels_of(const Image& image, const Pixel& colour) {
    int count = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) count += image.pixel(x, y) == colour ? 1 : 0;
    }
    return count;
}

}  // namespace

TEST_CASE("An arrow is seen along all of its length, and ends at its tip", "[marks]") {
    OffscreenRenderer offscreen(width, height);
    for (const auto& [from, to] : {std::pair{glm::vec3(-1.0f, 0.5f, 0.0f), glm::vec3(2.0f, -1.0f, 0.0f)},
                                   std::pair{glm::vec3(1.0f, -1.0f, 3.0f), glm::vec3(0.5f, 2.0f, -4.0f)},
                                   std::pair{glm::vec3(-4.0f, 2.0f, 0.0f), glm::vec3(-1.0f, 2.0f, 0.0f)}}) {
        const Image image =
            offscreen.render({.camera = from_the_front, .arrows = {{.from = from, .to = to, .colour = red}}});
        for (const float part : {0.0f, 0.3f, 0.6f, 0.97f}) {
            CHECK(is_red(colour_at(image, from + part * (to - from))));
        }
        for (const float part : {-0.2f, 1.1f}) {
            CHECK(colour_at(image, from + part * (to - from)) == image.pixel(0, 0));
        }
    }
}

TEST_CASE("Marks are projected like bodies, whatever the camera and the shape of the image", "[marks]") {
    const Camera askew{
        .eye = {11.0f, 7.0f, 9.0f}, .target = {1.0f, 1.0f, 0.5f}, .vertical_field_of_view_degrees = 55.0f};
    const Camera straight_down{.eye = {0.0f, 20.0f, 0.0f}, .target = {0.0f, 0.0f, 0.0f}};
    for (const auto& [columns, rows] : {std::pair{320, 180}, std::pair{120, 260}}) {
        OffscreenRenderer offscreen(columns, rows);
        for (const Camera& camera : {askew, straight_down}) {
            for (const glm::vec3 place :
                 {glm::vec3(0.0f), glm::vec3(1.5f, 2.0f, -1.0f), glm::vec3(1.0f, -1.0f, 1.2f)}) {
                // A blue dot hides the middle of a red ball, and the ball's rim is seen on all sides.
                const Picture ball{.camera = camera, .bodies = {{.position = place, .shape = Sphere{0.6f}}}};
                Picture both = ball;
                both.dots = {{.position = place, .colour = blue}};
                const Image without = offscreen.render(ball);
                const Image with = offscreen.render(both);
                glm::vec2 ball_sum(0.0f), dot_sum(0.0f);
                float ball_count = 0.0f, dot_count = 0.0f;
                for (int y = 0; y < rows; ++y) {
                    for (int x = 0; x < columns; ++x) {
                        if (without.pixel(x, y) != without.pixel(0, 0)) {
                            ball_sum += glm::vec2(x, y);
                            ball_count += 1.0f;
                        }
                        if (is_blue(with.pixel(x, y))) {
                            dot_sum += glm::vec2(x, y);
                            dot_count += 1.0f;
                        }
                    }
                }
                REQUIRE(ball_count > 20.0f);
                REQUIRE(dot_count > 4.0f);
                const glm::vec2 apart = ball_sum / ball_count - dot_sum / dot_count;
                CHECK(std::abs(apart.x) < 1.0f);
                CHECK(std::abs(apart.y) < 1.0f);
            }
        }
    }
}

TEST_CASE("Marks are seen through what hides them in depth", "[marks]") {
    Picture picture{.camera = from_the_front,
                    .bodies = {{.shape = Box{glm::vec3(1.5f)}, .colour = ivory}},
                    .arrows = {{.from = {-0.8f, 0.5f, 0.0f}, .to = {0.8f, 0.5f, -1.0f}, .colour = red}},
                    .dots = {{.position = {0.0f, -0.5f, -1.0f}, .colour = blue}}};
    const Image image = OffscreenRenderer(width, height).render(picture);
    CHECK(is_red(colour_at(image, {0.0f, 0.5f, -0.5f})));
    CHECK(is_blue(colour_at(image, {0.0f, -0.5f, -1.0f})));
}

TEST_CASE("Marks change no other pixels", "[marks]") {
    OffscreenRenderer offscreen(width, height);
    Picture picture = all_kinds();
    const Image before = offscreen.render(picture);
    picture.camera = from_the_front;
    const Image ground = offscreen.render(picture);
    picture.arrows = {{.from = {-1.0f, 1.0f, 0.0f}, .to = {1.0f, 1.0f, 0.0f}, .colour = red}};
    picture.dots = {{.position = {2.0f, -1.0f, 0.0f}, .colour = blue}};
    const Image image = offscreen.render(picture);
    const auto [left, row] = pixel_from_the_front(width, height, picture.arrows[0].from);
    const auto [right, same_row] = pixel_from_the_front(width, height, picture.arrows[0].to);
    const auto [dot_x, dot_y] = pixel_from_the_front(width, height, picture.dots[0].position);
    int changed = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool near_arrow = x >= left - 3 && x <= right + 3 && std::abs(y - row) <= 5;
            const bool near_dot = std::abs(x - dot_x) <= 4 && std::abs(y - dot_y) <= 4;
            if (image.pixel(x, y) == ground.pixel(x, y)) continue;
            ++changed;
            CHECK((near_arrow || near_dot));
        }
    }
    CHECK(changed > 60);
    // And they leave no traces in the next picture.
    CHECK(offscreen.render(all_kinds()) == before);
}

TEST_CASE("What is behind the eye is not drawn", "[marks]") {
    const Image ground = plain(200);
    const Picture behind{.camera = from_the_front,
                         .arrows = {{.from = {-1.0f, 0.0f, 11.0f}, .to = {1.0f, 0.5f, 12.0f}, .colour = red}},
                         .dots = {{.position = {0.1f, 0.1f, 11.0f}, .colour = red}}};
    CHECK(marks_on(ground, behind) == ground);

    // Of an arrow that comes from behind, the part before the eye is seen, with its head.
    const Image coming =
        marks_on(ground, {.camera = from_the_front,
                          .arrows = {{.from = {0.5f, -1.0f, 15.0f}, .to = {0.5f, -1.0f, 0.0f}, .colour = red}}});
    CHECK(is_red(colour_at(coming, {0.5f, -1.0f, 1.0f})));
    CHECK(is_red(colour_at(coming, {0.5f, -1.0f, 5.0f})));
    CHECK(is_red(coming.pixel(width / 2 + 44, height - 1)));
    // Nothing above the tip, where it would be mirrored.
    for (int x = 0; x < width; ++x) CHECK(coming.pixel(x, height / 4) == ground.pixel(x, height / 4));

    // One that goes there shows no head, as its tip is not seen.
    const Image going =
        marks_on(plain(200), {.camera = from_the_front,
                              .arrows = {{.from = {0.0f, 0.0f, 0.0f}, .to = {0.05f, 0.0f, 10.5f}, .colour = red}}});
    const auto height_of_red = [](const Image& image) {
        int first = height;
        int last = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                if (!is_red(image.pixel(x, y))) continue;
                first = std::min(first, y);
                last = std::max(last, y);
            }
        }
        return last - first + 1;
    };
    CHECK(height_of_red(going) > 0);
    CHECK(height_of_red(going) <= 2);
}

TEST_CASE("Marks have an edge that separates them from dark and light ground", "[marks]") {
    const Picture picture{.camera = from_the_front,
                          .arrows = {{.from = {-2.0f, 1.0f, 0.0f}, .to = {2.0f, 1.0f, 0.0f}, .colour = red}},
                          .dots = {{.position = {0.0f, -1.0f, 0.0f}, .colour = red}}};
    const Image dark = marks_on(plain(0), picture);
    for (const glm::vec3 middle : {glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(0.0f, -1.0f, 0.0f)}) {
        const auto [x, y] = pixel_from_the_front(width, height, middle);
        CHECK(is_red(dark.pixel(x, y)));
        int lightest = 0;
        for (int row = y - 6; row <= y + 6; ++row) lightest = std::max(lightest, int{dark.pixel(x, row)[1]});
        CHECK(lightest > 100);
        CHECK(dark.pixel(x, y - 7) == Pixel{0, 0, 0});
    }
}

TEST_CASE("Later arrows lie over earlier ones and all of them over dots", "[marks]") {
    const Arrow across{.from = {-1.0f, 0.0f, 0.0f}, .to = {1.0f, 0.0f, 0.0f}, .colour = red};
    const Arrow upwards{.from = {0.0f, -1.0f, 0.0f}, .to = {0.0f, 1.0f, 0.0f}, .colour = blue};
    const Dot dot{.position = glm::vec3(0.0f), .colour = {0.0f, 0.8f, 0.0f}};
    Image large{1280, 720, std::vector<std::uint8_t>(std::size_t{3} * 1280 * 720, 128)};
    const Image first = marks_on(large, {.camera = from_the_front, .arrows = {across, upwards}, .dots = {dot}});
    const Image second = marks_on(large, {.camera = from_the_front, .arrows = {upwards, across}, .dots = {dot}});
    CHECK(is_blue(first.pixel(640, 360)));
    CHECK(is_red(second.pixel(640, 360)));
}

TEST_CASE("Marks are as wide for the height of every image, and at least a little", "[marks]") {
    const Picture picture{.camera = from_the_front,
                          .arrows = {{.from = {-2.0f, 1.0f, 0.0f}, .to = {2.0f, 1.0f, -6.0f}, .colour = red}},
                          .dots = {{.position = {0.0f, -1.0f, 0.0f}, .colour = blue}}};
    const auto marked = [&](int columns, int rows) {
        Image image{columns, rows, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * columns * rows), 255)};
        draw_marks(image, picture);
        return image;
    };
    const Pixel pure_blue{26, 51, 230};
    const int at_720 = pixels_of(marked(1280, 720), pure_blue);
    const int at_1440 = pixels_of(marked(2560, 1440), pure_blue);
    CHECK(at_720 == Approx(3.1416 * 4.0 * 4.0).margin(12.0));
    CHECK(at_1440 == Approx(3.1416 * 8.5 * 8.5).margin(25.0));
    CHECK(pixels_of(marked(160, 90), pure_blue) >= 4);
    // The shaft: as wide where it is near as where it is far.
    const Image image = marked(1280, 720);
    const auto thickness = [&](int x) {
        double sum = 0.0;
        for (int y = 0; y < 360; ++y) sum += 1.0 - (image.pixel(x, y)[2] - 25.0) / 230.0;
        return sum;
    };
    CHECK(thickness(480) == Approx(720.0 / 220.0).margin(0.4));
    CHECK(thickness(480) == Approx(thickness(700)).margin(0.1));
}

TEST_CASE("An arrow too short to point anywhere is left out", "[marks]") {
    const Image ground = plain(200);
    // A pixel is 3.8 cm here.
    const auto arrow_of = [&](const glm::vec3& along) {
        return marks_on(ground, {.camera = from_the_front, .arrows = {{.to = along, .colour = red}}});
    };
    CHECK(arrow_of(glm::vec3(0.0f)) == ground);
    CHECK(arrow_of({0.05f, 0.0f, 0.0f}) == ground);
    CHECK(arrow_of({0.0f, 0.0f, 5.0f}) == ground);  // straight towards the eye
    CHECK(arrow_of({0.1f, 0.0f, 0.0f}) != ground);
}

TEST_CASE("An arrow may be as long as numbers are", "[marks]") {
    const Image ground = plain(200);
    const Image image = marks_on(
        ground, {.camera = from_the_front,
                 .arrows = {{.from = {0.0f, 0.0f, 0.0f}, .to = {3e38f, 0.0f, 0.0f}, .colour = red},
                            {.from = {-3e38f, -3e38f, -3e38f}, .to = {3e38f, 3e38f, 3e38f}, .colour = blue}},
                 .dots = {{.position = {-3e38f, 3e38f, 3e38f}}}});
    CHECK(is_red(image.pixel(width / 2 + 10, height / 2)));
    CHECK(is_red(image.pixel(width - 1, height / 2)));
    CHECK_FALSE(is_red(image.pixel(width / 2 - 10, height / 2)));
}
