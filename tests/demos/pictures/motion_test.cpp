// Trails, ghosts and motion blur.
#include "demos/pictures/film/motion.h"

#include "demos/base/text/errors.h"
#include "demos/options/choices.h"
#include "demos/pictures/draw_list.h"
#include "tests/catch.h"

#include <set>

using namespace pushfactor::demos;
using namespace pushfactor::demos::pictures;
using pushfactor::renderer::Picture;

namespace {

Choices choices_of(const std::vector<std::pair<std::string, std::string>>& options) {
    GivenOptions given;
    given.add("seconds", "1", "--seconds");
    for (const auto& [name, value] : options) given.add(name, value, "--" + name);
    return understand("stack", given);
}

// Plays the stack for some steps and notes each.
struct Played {
    explicit Played(const Choices& choices, int steps) : run(choices), motion(choices.frames, run) {
        motion.note(now());
        for (int i = 0; i < steps; ++i) {
            run.advance();
            motion.note(now());
        }
    }
    Picture now() const { return draw_list(run.scene(), run.scene().view); }

    Simulation run;
    Motion motion;
};

}  // namespace

TEST_CASE("a ghost is the body where it was, paler the older it is, and what has not moved has none") {
    Played played(choices_of({{"ghosts", "0,0.1"}}), 12);
    Picture picture = played.now();
    const std::vector<pushfactor::renderer::Body> own = picture.bodies;
    played.motion.add_ghosts(picture);
    REQUIRE(picture.bodies.size() == 3 * own.size());
    // The start, and as far behind as the older of two.
    const glm::vec3 back = picture.camera.target - picture.camera.eye;
    CHECK(picture.bodies[own.size()].position.y == Approx(2.0f + 8e-3f * back.y));
    CHECK(picture.bodies[2 * own.size()].position.y < 2.0f);  // at 0.1 s
    CHECK(picture.bodies[2 * own.size()].position.y > own[0].position.y);
    const auto paleness = [&](std::size_t i) { return picture.bodies[i].colour.g - own[0].colour.g; };
    CHECK(paleness(own.size()) > paleness(2 * own.size()));
    CHECK(paleness(2 * own.size()) > 0.1f);

    Picture same = Played(choices_of({{"ghosts", "0"}}), 0).now();
    Played(choices_of({{"ghosts", "0"}}), 0).motion.add_ghosts(same);
    CHECK(same.bodies.size() == own.size());
    CHECK_THROWS_WITH(Motion(choices_of({{"ghosts", "0.005"}}).frames, played.run),
                      Catch::Contains("--ghosts 0.005: must be a whole number of steps"));
}

TEST_CASE("a trail ends at the centre of its body, reaches back as far as it should and fades") {
    for (const double seconds : {0.1, 0.3}) {
        Played played(choices_of({{"overlay", "trails:" + std::to_string(seconds)}}), 30);
        Picture picture = played.now();
        played.motion.add_trails(picture);
        REQUIRE(!picture.arrows.empty());
        std::set<float> starts;
        float nearest = 1e9f;
        for (const auto& line : picture.arrows) {
            CHECK(!line.head);
            nearest = std::min(nearest, glm::distance(line.to, picture.bodies[4].position));
            starts.insert(line.from.y);
        }
        CHECK(nearest < 0.15f);
        // The topmost cube falls freely until it meets the others.
        const double from = 0.5 - seconds;
        CHECK(*starts.rbegin() == Approx(2.0 + 4 * 3.0 - 5.0 * from * from).margin(0.5));
        CHECK(picture.arrows.front().colour.g != picture.arrows.back().colour.g);
    }
    CHECK(choices_of({{"overlay", "trails"}}).frames.trail_seconds() == 1.0);
    CHECK(choices_of({}).frames.trail_seconds() == 0.0);
}

TEST_CASE("an open shutter sees the poses between steps, each sample another, and all of the time") {
    const Choices choices = choices_of({{"shutter", "0.5"}, {"samples", "8"}, {"fps", "15"}});
    Played played(choices, 12);
    CHECK(played.motion.open() == Approx(0.5 / 15.0));
    const std::vector<Moment> moments = played.motion.while_open();
    REQUIRE(moments.size() == 3);
    CHECK(moments.back().time == Approx(0.2));
    CHECK(moments.front().time == Approx(0.2 - 2.0 / 60.0));
    const std::vector<Picture> pictures = spread(moments, 0.2 - 0.5 / 15.0, 0.2, 64);
    REQUIRE(pictures.size() == 64);
    double sum = 0.0;
    std::set<float> heights;
    for (const Picture& picture : pictures) {
        const float y = picture.bodies[0].position.y;
        CHECK(y <= moments.front().picture.bodies[0].position.y);
        CHECK(y >= moments.back().picture.bodies[0].position.y);
        sum += y / 64.0;
        heights.insert(y);
    }
    CHECK(heights.size() == 64);
    CHECK(sum == Approx(moments[1].picture.bodies[0].position.y).margin(0.01));
    // In the middle between two steps bodies are half way.
    const std::vector<Picture> one = spread({moments[0], moments[1]}, moments[0].time, moments[1].time, 1);
    CHECK(one[0].bodies[0].position.y < moments[0].picture.bodies[0].position.y);
    CHECK(one[0].bodies[0].position.y > moments[1].picture.bodies[0].position.y);
    CHECK(Played(choices_of({}), 3).motion.while_open().empty());
    CHECK_THROWS_AS(choices_of({{"shutter", "0.5"}}), UsageError);
    CHECK_THROWS_AS(choices_of({{"shutter", "2"}, {"samples", "4"}}), UsageError);
}
