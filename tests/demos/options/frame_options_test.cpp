#include "demos/options/frame_options.h"

#include "demos/base/text/errors.h"
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

namespace {

// The parsed option; nothing when it is refused.
std::optional<FrameChoices> set(std::string_view name, std::string_view text) {
    FrameChoices choices;
    for (const FrameOption& option : frame_options()) {
        if (option.name == name && option.set(choices, text)) return choices;
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("a film in slow motion has its frames nearer together in simulated time") {
    FrameChoices choices;
    choices.play_speed = Rational{1, 4};
    choices.fps = Rational{30, 1};
    CHECK(plan_frames(choices, Rational{1, 120}, 120).size() == 121);
    CHECK_THROWS_WITH(plan_frames(choices, Rational{1, 60}, 60),
                      Catch::Contains("--play-speed 0.25") && Catch::Contains("rates that fit are 15"));
}

TEST_CASE("overlays are named, may have a scale, and are not named twice") {
    const auto choices = set("overlay", "forces:50,contacts");
    REQUIRE(choices);
    CHECK(choices->overlay[0].units_a_metre == 50.0);
    CHECK(!choices->overlay[1].units_a_metre);
    CHECK(to_text(choices->overlay) == "forces:50,contacts");
    CHECK(to_text(set("overlay", "trails:0.5,push")->overlay) == "trails:0.5,push");
    CHECK(set("overlay", "trails")->trail_seconds() == 1.0);
    for (const char* wrong : {"force", "", "forces,", "contacts:3", "forces:0", "forces:x", "push,push",
                              "islands:3", "trails:0", "trails:x"}) {
        INFO(wrong);
        CHECK(!set("overlay", wrong));
    }
}

TEST_CASE("a camera turns about the vertical through its target at the speed that was given") {
    const auto choices = set("camera", "orbit:90");
    REQUIRE(choices);
    const View view{.eye = {3, 5, 0}, .target = {1, 1, 0}};
    const View after = turned(choices->camera, view, 1.0);
    CHECK((after.eye - pushfactor::engine::Vector3(1, 5, -2)).norm() < 1e-12);
    CHECK(set("camera", "fit,orbit:-3")->camera.fit);
    CHECK(!set("camera", "scene")->camera.fit);
    for (const char* wrong : {"orbit", "orbit:x", "", "fit,"}) CHECK(!set("camera", wrong));
    CHECK_THROWS_WITH(set("camera", "nowhere.json"), Catch::Contains("nowhere.json: cannot be read"));
}
