// The scenes of the stability report's chapters on friction, floors, thin bodies and ball joints, and their files
// in tests/scenes, which build/release/tests/make_expected writes.
#include "demos/base/text/json.h"
#include "demos/reports/stability/stability.h"
#include "demos/runs/simulation.h"
#include "demos/scenes/scene_file.h"
#include "tests/catch.h"
#include "tests/demos/program.h"
#include "tests/demos/reports/stability_files.h"
#include "tests/settings.h"

#include <cmath>
#include <map>
#include <numbers>
#include <set>

using namespace pushfactor::tests;
using namespace pushfactor::demos;
using namespace pushfactor::demos::reports::stability;

namespace {

using pushfactor::engine::Vector3;

// Compilers may differ in the last digit of a sine.
void check_same(const Json& file, const Json& scene) {
    const Json left = file.flatten();
    const Json right = scene.flatten();
    REQUIRE(left.size() == right.size());
    for (const auto& [key, value] : left.items()) {
        INFO(key);
        REQUIRE(right.contains(key));
        if (value.is_number()) {
            CHECK(value.get<double>() == Approx(right[key].get<double>()).margin(1e-12));
        } else {
            CHECK(value == right[key]);
        }
    }
}

// The deepest overlap of a scene's bodies at its start, m.
double penetration_of(const SceneDescription& scene) {
    const Settings settings = pushfactor::tests::awake_settings("default");
    return Simulation(build_scene(scene, settings), settings).sample().penetration.max;
}

}  // namespace

TEST_CASE("the scene files of the stability report say what its scenes are") {
    for (const auto& [name, scene] : scenes_with_files()) {
        INFO(name);
        check_same(parse_json(read_file(file_of(name))), parse_json(scene_file_text(scene)));
    }
}

TEST_CASE("every scene file of the tests runs for a second") {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scene_folder)) {
        INFO(entry.path());
        ++files;
        for (const char* const preset : {"default", "exact"}) {
            const Ended ended =
                run_program("run '" + entry.path().string() + "' --seconds 1 --preset " + std::string(preset));
            INFO(ended.err);
            CHECK(ended.status == 0);
        }
    }
    CHECK(files >= static_cast<int>(scenes_with_files().size()));
}

TEST_CASE("cases have names of their own, and each one an expectation and a wanted outcome") {
    std::set<std::string> names;
    for (const Chapter& chapter : chapters(false)) {
        for (const Case& one : chapter.cases) {
            INFO(one.name);
            CHECK(names.insert(one.name).second);
            CHECK(!one.expected.empty());
            CHECK(!one.wanted.empty());
        }
    }
}

TEST_CASE("scenes about friction, floors and thin bodies begin without overlap") {
    const std::set<std::string> wanted{"slopes", "directions", "slab", "rolling", "hovering", "seams", "thin"};
    int scenes = 0;
    for (const Chapter& chapter : chapters(false)) {
        if (!wanted.contains(chapter.name)) continue;
        for (const Case& one : chapter.cases) {
            INFO(one.name);
            ++scenes;
            CHECK(penetration_of(*one.own()) < 1e-12);
        }
    }
    CHECK(scenes > 40);
}

TEST_CASE("the bodies on a floor of boxes have twins that differ in their place alone") {
    for (const double uneven : {0.0, 0.0005}) {
        const SceneDescription scene = seam_floor({.speed = 4.0, .angle = 0.4, .uneven = uneven});
        std::vector<const BodyDescription*> movable;
        for (const BodyDescription& body : scene.bodies) {
            if (body.mass) movable.push_back(&body);
        }
        const std::size_t half = movable.size() / 2;
        REQUIRE(movable.size() == (uneven == 0.0 ? 6 : 4));
        for (std::size_t i = 0; i < half; ++i) {
            const BodyDescription& one = *movable[i];
            const BodyDescription& twin = *movable[half + i];
            CHECK(one.velocity == twin.velocity);
            CHECK(one.angular_velocity == twin.angular_velocity);
            CHECK(one.orientation.coeffs() == twin.orientation.coeffs());
            CHECK((one.position - twin.position).isApprox(movable[0]->position - movable[half]->position));
        }
    }
}

TEST_CASE("cards that lean touch what they lean on") {
    // The upper corners of both cards of a house, on the inner side, meet in the plane of symmetry.
    for (const double angle : {0.1, 0.3, 0.5}) {
        const SceneDescription house = card_house(angle);
        for (const auto& [body, side] : {std::pair(1, 1.0), std::pair(2, -1.0)}) {
            const BodyDescription& card = house.bodies[static_cast<std::size_t>(body)];
            const Vector3 size = std::get<BoxShape>(card.shape).size;
            const Vector3 corner =
                card.position + card.orientation * (0.5 * Vector3(side * size.x(), size.y(), size.z()));
            CHECK(corner.x() == Approx(0.0).margin(1e-12));
        }
        // The edge of the box is in the plane of the face of the card.
        const BodyDescription card = card_leaning(angle).bodies.back();
        const Vector3 inside = card.orientation.conjugate() * (Vector3(0, 0.4, 0) - card.position);
        CHECK(inside.x() == Approx(0.5 * card_thickness));
    }
}

TEST_CASE("the period of a rod on a ball joint grows from that of small swings") {
    const double small = 2.0 * std::numbers::pi * std::sqrt((1.0 / 3.0 + 0.04 * 0.04 / 12.0) / (10.0 * 0.5));
    CHECK(rod_pendulum_period(1e-4) == Approx(small).epsilon(1e-8));
    // 1 + angle^2 / 16 + 11 angle^4 / 3072, the series of the elliptic integral.
    CHECK(rod_pendulum_period(0.5) == Approx(small * (1.0 + 0.25 / 16.0 + 11.0 * 0.0625 / 3072.0)).epsilon(1e-4));
}

TEST_CASE("the ends of a chain's rods lie on each other at the start") {
    const SceneDescription chain = ball_joint_chain(0.7);
    const auto place = [&](const DistanceDescription::End& end) -> Vector3 {
        for (const BodyDescription& body : chain.bodies) {
            if (body.name == end.body) return body.position + body.orientation * end.point;
        }
        return end.point;
    };
    REQUIRE(chain.distances.size() == 5);
    for (const DistanceDescription& joint : chain.distances) {
        CHECK(joint.length == 0.0);
        CHECK((place(joint.a) - place(joint.b)).norm() < 1e-15);
    }
}
