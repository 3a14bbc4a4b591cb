// Pairs that pass each other keep their momenta, pairs that touch meet in the right step and direction, and the
// judge sees when they do not.
#include "tests/catch.h"
#include "tests/fuzz/meeting_campaign.h"

using namespace pushfactor;
using namespace pushfactor::tests;

namespace {

void check_hundred(Prediction::Kind kind) {
    for (const JudgedMeeting& one :
         judge_meetings({.count = 100, .presets = {"default", "exact"}, .only = kind}, [](long) { return true; })) {
        INFO(one.meeting.scene.name << " under " << one.preset << ", step " << one.verdict.step);
        INFO(one.verdict.failure);
        // The row that the step begins with may be without a force where the solution turns the pair further: then
        // a row of the end of the step has it all (continuous_collision.h).
        CHECK((one.verdict.fault == MeetingFault::none || one.verdict.fault == MeetingFault::unused_normal));
    }
}

}  // namespace

TEST_CASE("a hundred pairs that pass each other keep momentum and angular momentum to 1e-9", "[meet]") {
    check_hundred(Prediction::Kind::passes);
}

TEST_CASE("a hundred pairs that touch do so in the step and with the normal of their free motion", "[meet]") {
    check_hundred(Prediction::Kind::touches);
}

TEST_CASE("a pair that touches is no pair that passes, nor one that touches earlier, later or elsewhere") {
    const Meeting touch = draw_meeting(Prediction::Kind::touches, 0, 3);
    REQUIRE(touch.prediction.normal);
    REQUIRE(touch.prediction.step > 1);
    const auto fault_of = [](const Meeting& meeting) { return judge_meeting(meeting, "exact").fault; };
    CHECK(fault_of(touch) == MeetingFault::none);

    Meeting other = touch;
    other.prediction.step = 0;
    CHECK(fault_of(other) == MeetingFault::disturbed);
    other.prediction.step = touch.prediction.step - 1;
    CHECK(fault_of(other) == MeetingFault::missed);
    other.prediction.step = ++other.steps;
    CHECK(fault_of(other) == MeetingFault::early);
    other = touch;
    other.prediction.in_margin = false;
    *other.prediction.normal = (*touch.prediction.normal + engine::Vector3(0.02, 0.02, 0)).normalized();
    CHECK(fault_of(other) == MeetingFault::wrong_normal);
    *other.prediction.normal = -*touch.prediction.normal;
    CHECK(fault_of(other) == MeetingFault::wrong_normal);
    other.scene.options["margin"] = "-1";
    CHECK(fault_of(other) == MeetingFault::refused);
}

TEST_CASE("a pair is drawn again from its seed") {
    for (const auto kind : {Prediction::Kind::passes, Prediction::Kind::touches}) {
        const Meeting one = draw_meeting(kind, 5, 7), other = draw_meeting(kind, 5, 7);
        CHECK(one.scene.bodies[1].position == other.scene.bodies[1].position);
        CHECK(draw_meeting(kind, 5, 8).scene.bodies[1].position != one.scene.bodies[1].position);
    }
}
