// Thin bodies that fall do not sink into what they land on, and the judge measures how deep one is.
#include "tests/fuzz/thin_falls.h"

#include "tests/catch.h"

using namespace pushfactor;
using namespace pushfactor::tests;

// A body that an impact turns by much in the rest of the step leaves the contact that was found, and the step is
// taken again in more parts.
TEST_CASE("rods, plates and coins that fall overlap what they meet by at most a tenth of their thickness") {
    for (const char* preset : {"default", "exact"}) {
        for (const JudgedFall& one : judge_thin_falls(27, 1, preset, [](long) { return true; })) {
            INFO(one.fall.scene.name << " under " << preset << ", step " << one.step << " " << one.error);
            CHECK(one.error == "");
            CHECK(one.deepest <= most_thin_overlap);
        }
    }
}

TEST_CASE("a thin body that starts in the ground or in its target is as deep as it was put there") {
    for (const std::size_t kind : {0u, 4u, 7u}) {
        ThinFall fall = draw_thin_fall(kind, 1);
        fall.scene.gravity.setZero();
        fall.scene.options["seconds"] = "0.05";
        fall.scene.options["push"] = "none";
        demos::BodyDescription& piece = fall.scene.bodies[1];
        piece.shape = demos::BoxShape{{1.0, fall.thickness, fall.thickness}};
        piece.orientation.setIdentity();
        piece.angular_velocity.setZero();
        piece.position = {0, 0.2 * fall.thickness, 0};
        if (kind > 0) {
            demos::BodyDescription& target = fall.scene.bodies[2];
            target.shape = demos::BoxShape{{2, 1, 2}};
            target.orientation.setIdentity();
            target.position = {0, 2, 0};
            piece.position.y() = 2.5 + 0.2 * fall.thickness;
        }
        CHECK(judge_thin_fall(fall, "exact").deepest == Approx(0.3).margin(1e-9));
    }
}
