// The default camera of scene files.
#include "demos/options/look_choices.h"
#include "demos/pictures/camera/framing.h"
#include "demos/pictures/camera/survey.h"
#include "demos/runs/simulation.h"
#include "demos/scenes/scene_file.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::demos::pictures;
using tests::Folder;

namespace {

// A ball that is thrown far away from where it starts.
std::string thrown(const std::string& camera = "", const std::string& velocity = "[30, 12, -4]") {
    return R"({"version": 1, "name": "thrown", "contacts": true, "bodies": [
        {"name": "ground", "shape": "plane", "static": true},
        {"name": "ball", "shape": "sphere", "radius_m": 0.5, "mass_kg": 1, "position_m": [0, 0.5, 0],
         "velocity_m_per_s": )" +
           velocity + "}]" + camera + "}";
}

struct Shown {
    std::vector<ComparedRun> panels;
    std::vector<Frames> frames;
};

Shown shown(const std::string& text, const std::string& compare = "") {
    const Folder folder;
    folder.write("my.json", text);
    GivenOptions given;
    given.add("seconds", "3", "--seconds");
    if (!compare.empty()) given.add("compare", compare, "--compare");
    Shown all{.panels = compared_runs((folder / "my.json").string(), given), .frames = {}};
    for (const ComparedRun& panel : all.panels) {
        const Settings& settings = panel.choices.settings;
        all.frames.push_back(plan_frames(panel.choices.frames, settings.dt, whole_steps(settings)));
    }
    return all;
}

// Whether the ball is in the picture at every step.
bool is_seen(const Choices& choices, double aspect) {
    Simulation simulation(choices);
    for (long step = 0; step <= whole_steps(choices.settings); ++step) {
        const Eigen::Vector2d place =
            place_in_picture(simulation.scene().world.bodies[1].position, choices.description.view, aspect);
        if (place.minCoeff() < 0.0 || place.maxCoeff() > 1.0) return false;
        simulation.advance();
    }
    return true;
}

void give_overview(Shown& all) {
    SurveyOnce survey(all.frames);
    add_overview(all.panels, survey);
}

}  // namespace

TEST_CASE("a scene file without a camera gets one that sees the whole motion, in every panel") {
    for (const std::string compare : {"", "restitution=0,0.5,1"}) {
        Shown all = shown(thrown(), compare);
        const double aspect = 1280.0 / 720.0 / static_cast<double>(all.panels.size());
        CHECK(!is_seen(all.panels.front().choices, aspect));
        give_overview(all);
        for (const ComparedRun& panel : all.panels) {
            INFO(panel.label);
            CHECK(is_seen(panel.choices, aspect));
        }
    }
}

TEST_CASE(
    "a camera that a scene file names stays, and one that it does not name is not made up in what is written") {
    const std::string camera = R"(, "camera": {"eye_m": [1, 2, 30], "target_m": [0, 1, 0]})";
    Shown all = shown(thrown(camera));
    give_overview(all);
    const SceneDescription& with = all.panels.front().choices.description;
    CHECK(with.view.eye == engine::Vector3(1, 2, 30));
    CHECK(with.view.target == engine::Vector3(0, 1, 0));
    CHECK_THAT(scene_file_text(with), Catch::Contains("\"camera\""));
    CHECK_THAT(scene_file_text(shown(thrown()).panels.front().choices.description), !Catch::Contains("\"camera\""));
}

TEST_CASE("what leaves for good does not make all else invisible") {
    Shown all = shown(thrown("", "[1e5, 1e5, 0]"));
    give_overview(all);
    const View& view = all.panels.front().choices.description.view;
    CHECK((view.eye - view.target).norm() < 1000.0);  // a ball of 0.5 m is a pixel there
}

TEST_CASE("an overview and a camera that fits are found by one run, which does not feel the overview") {
    Shown all = shown(thrown());
    all.panels.front().choices.frames.camera = *parse_camera("fit");
    std::vector<long> steps;
    SurveyOnce survey(all.frames, [&steps](Simulation& run, long step) {
        while (run.sample().step < step) run.advance();
        steps.push_back(step);
    });
    add_overview(all.panels, survey);
    const std::vector<engine::Vector3> points = survey.of(all.panels).subject.points;
    CHECK(steps.size() == all.frames.front().size());
    CHECK(!points.empty());
    CHECK(points == pictures::survey(all.panels, all.frames).subject.points);
}
