#include "demos/frame_options.h"

#include "demos/errors.h"
#include "tests/catch.h"

using namespace pushfactor::demos;

TEST_CASE("a sequence has a frame at every n / fps, the start and the end included") {
    FrameChoices choices;
    choices.fps = Rational{30, 1};
    const auto frames = plan_frames(choices, Rational{1, 60}, 600);
    REQUIRE(frames.size() == 301);
    CHECK(frames[7].step == 14);
    CHECK(frames[7].name == "frame_000007.png");
    CHECK(frames.back().step == 600);
    CHECK(plan_frames({}, Rational{1, 240}, 2400).size() == 601);  // 60 when nothing is given
}

TEST_CASE("stills come in the order of time, once each") {
    FrameChoices choices;
    choices.at = {Rational{1, 1}, Rational{0, 1}, Rational{1, 60}, Rational{1, 1}};
    const auto frames = plan_frames(choices, Rational{1, 60}, 60);
    REQUIRE(frames.size() == 3);
    CHECK(frames[0].name == "at_0s.png");
    CHECK(frames[1].name == "at_1_60s.png");
    CHECK(frames[2].step == 60);
}

TEST_CASE("a step that is no part of a frame is refused, whatever the step") {
    CHECK(steps_a_frame({60, 1}, {1, 240}) == 4);
    CHECK_THROWS_AS(steps_a_frame({60, 1}, {1, 100}), UsageError);
    CHECK_THROWS_WITH(steps_a_frame({60, 1}, {2, 125}), Catch::Contains("62.5"));
}
