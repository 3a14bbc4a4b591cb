// Cameras that fit: what is to be seen is in the picture, and fills it.

#include "demos/options/comparison.h"
#include "demos/pictures/camera/framing.h"
#include "demos/pictures/camera/survey.h"
#include "demos/runs/simulation.h"
#include "demos/scenes/catalogue.h"
#include "tests/catch.h"
#include "tests/demos/program.h"
#include "tests/random.h"

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::demos::pictures;
using engine::Vector3;

namespace {

struct Still {
    View view;  // the scene's
    Subject subject;
};

Still still_of(const std::string& scene, const std::string& at) {
    GivenOptions given;
    given.add("at", at, "--at");
    const std::vector<ComparedRun> runs = compared_runs(scene, given);
    const Choices& choices = runs.front().choices;
    CHECK(choices.frames.camera.fit);
    const std::vector<Frames> frames{
        plan_frames(choices.frames, choices.settings.dt, whole_steps(choices.settings))};
    return {.view = choices.description.view, .subject = survey(runs, frames).subject};
}

}  // namespace

TEST_CASE("an outline has the farthest points, to a hundredth of the size") {
    tests::Random random(3);
    Outline outline;
    std::vector<Vector3> points;
    CHECK(outline.empty());
    for (int i = 0; i < 500; ++i) {
        points.emplace_back(random.in(-3, 3), random.in(0, 8), random.in(-1, 2));
        outline.add(Ball{points.back()});
    }
    outline.add(Ball{{0, 0, 0}, 1.0});
    const std::vector<Vector3> kept = outline.points();
    CHECK(kept.size() <= 200);
    for (int i = 0; i < 50; ++i) {
        const Vector3 direction = Vector3(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)).normalized();
        const auto farthest = [&](const std::vector<Vector3>& of) {
            double most = -1e9;
            for (const Vector3& point : of) most = std::max(most, direction.dot(point));
            return most;
        };
        CHECK(farthest(kept) > farthest(points) - 0.09);
    }
    Outline both;
    both.add(outline);
    CHECK(both.points() == kept);
}

TEST_CASE("the subject of every scene is in the picture and fills it, in any aspect") {
    for (const SceneEntry& scene : catalogue()) {
        const Still still = still_of(std::string(scene.name), "0,1");
        for (const double aspect : {16.0 / 9.0, 1.0, 9.0 / 16.0, 0.38}) {
            INFO(scene.name << " " << aspect);
            const View view = composed(still.view, still.subject, aspect);
            const Eigen::AlignedBox2d extent = extent_of(still.subject.points, view, aspect);
            CHECK(extent.min().x() > 0.03);
            CHECK(extent.min().y() > 0.03);
            CHECK(extent.max().x() < 0.97);
            CHECK(extent.max().y() < 0.97);
            CHECK(extent.sizes().maxCoeff() > 0.85);
            CHECK(std::abs(0.5 * (extent.min().x() + extent.max().x()) - 0.5) < 0.13);
        }
    }
}

TEST_CASE("a row that recedes from the camera fills a tall picture better than one across it") {
    Subject row;
    for (const double x : {-10.0, 10.0}) {
        for (const double y : {0.0, 1.0}) row.points.emplace_back(x, y, 0.0);
    }
    const View view{.eye = {0, 6, 20}, .target = {0, 0, 0}};
    const auto area = [&](const View& from) {
        const Eigen::AlignedBox2d extent = extent_of(row.points, from, 0.5);
        return extent.volume();
    };
    const std::vector<Ball> balls = [&] {
        std::vector<Ball> list;
        for (const Vector3& point : row.points) list.push_back({.centre = point});
        return list;
    }();
    CHECK(area(composed(view, row, 0.5)) > 2.0 * area(fitted(view, balls, 0.5)));
    // A subject that fills its picture is seen from where the scene wants it to be.
    const View wide =
        composed({.eye = {0, 0, 20}, .target = {0, 0, 0}},
                 {.points = {{-16, -9, 0}, {16, -9, 0}, {16, 9, 0}, {-16, 9, 0}}, .shadow = {}}, 16.0 / 9.0);
    CHECK(std::abs(wide.eye.x() - wide.target.x()) < 1e-9);
}

TEST_CASE("walls of a funnel belong to its picture, and a shadow moves what has room") {
    const Still funnel = still_of("funnel", "8");
    double top = 0.0, highest_ball = 0.0;
    for (const Vector3& point : funnel.subject.points) top = std::max(top, std::abs(point.x()));
    for (const Vector3& point : still_of("stack", "1").subject.points)
        highest_ball = std::max(highest_ball, point.y());
    CHECK(top > 3.2);  // the rim
    CHECK(highest_ball > 11.9);
    const Still stack = still_of("stack", "1");
    REQUIRE(!stack.subject.shadow.empty());
    const View with = composed(stack.view, stack.subject, 16.0 / 9.0);
    Subject bare = stack.subject;
    bare.shadow.clear();
    const View without = composed(stack.view, bare, 16.0 / 9.0);
    const auto middle = [&](const View& view) {
        const Eigen::AlignedBox2d extent = extent_of(stack.subject.points, view, 16.0 / 9.0);
        return 0.5 * (extent.min().x() + extent.max().x());
    };
    CHECK(middle(with) < middle(without) - 0.05);  // the shadow falls to the right
}

TEST_CASE("stills and comparisons fit by default, and what is written says which camera it was") {
    const auto choices_of = [](const std::string& option, const std::string& value,
                               const std::string& camera = "") {
        GivenOptions given;
        if (!option.empty()) given.add(option, value, "--" + option);
        if (!camera.empty()) given.add("camera", camera, "--camera");
        return std::pair(understand("stack", given), given);
    };
    CHECK(!choices_of("", "").first.frames.camera.fit);
    CHECK(choices_of("at", "1").first.frames.camera.fit);
    CHECK(choices_of("compare", "push=none,persistent").first.frames.camera.fit);
    CHECK(!choices_of("at", "1", "scene").first.frames.camera.fit);
    const auto written = [&](const std::string& option, const std::string& value) {
        const auto [choices, given] = choices_of(option, value);
        return config_text(choices, given);
    };
    CHECK_THAT(written("", ""), Catch::Contains("\"camera\": \"scene\""));
    CHECK_THAT(written("at", "1"), Catch::Contains("\"camera\": \"fit\""));
    CHECK_THAT(written("compare", "push=none,persistent"), Catch::Contains("\"camera\": \"fit\""));

    // What does not say so was written when stills had the scene's camera.
    const tests::Folder folder;
    folder.write("old.json", R"({"scene": "stack", "at": "1"})");
    GivenOptions old;
    add_config(folder / "old.json", old);
    CHECK(!understand("stack", old).frames.camera.fit);
}
