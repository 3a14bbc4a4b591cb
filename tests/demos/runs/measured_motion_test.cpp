// Measured motion beside a scene: it changes nothing, and is compared with what is computed.
#include "demos/scenes/motions/measured_motion.h"

#include "demos/base/text/json.h"
#include "demos/options/named_run.h"
#include "demos/runs/measured_errors.h"
#include "demos/scenes/scene_file.h"
#include "tests/catch.h"
#include "tests/demos/csv.h"
#include "tests/demos/program.h"
#include "tests/texts.h"

#include <cmath>

using namespace pushfactor::demos;
using namespace pushfactor::tests;
using pushfactor::engine::Vector3;

namespace {

// A brick of 2 kg whose mass is not spread evenly, thrown onto a plane.
constexpr const char* brick = R"({
  "version": 1, "name": "thrown", "gravity_m_per_s2": [0, -10, 0], "contacts": true,
  "bodies": [
    {"name": "ground", "shape": "plane"},
    {"name": "brick", "shape": "box", "size_m": [0.4, 0.2, 0.1], "mass_kg": 2, "position_m": [0, 0.8, 0],
     "moments_of_inertia_kg_m2": [0.02, 0.05, 0.04], "velocity_m_per_s": [1, 0, 0],
     "angular_velocity_rad_per_s": [3, 1, 2]MORE}],
  "options": {"seconds": "1", "dt": "1/100"OPTIONS}
})";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

std::string brick_with(const std::string& more, const std::string& options = "") {
    return replaced(replaced(brick, "MORE", more), "OPTIONS", options);
}

}  // namespace

TEST_CASE("a run is at its own trajectory, and elsewhere with another friction") {
    const Folder folder;
    require_success(folder, "pushfactor run funnel --count 8 --seconds 2 --trajectory own.csv > plain.json");
    require_success(folder, "pushfactor run funnel --count 8 --seconds 2 --measured own.csv --errors same.csv");
    require_success(
        folder, "pushfactor run funnel --count 8 --seconds 2 --friction 0 --measured own.csv --errors other.csv");
    const auto same = table_of(folder.read("same.csv")), other = table_of(folder.read("other.csv"));
    REQUIRE(same.size() == 1 + 8 * 121);
    REQUIRE(other.size() == same.size());
    for (std::size_t i = 1; i < same.size(); ++i) {
        REQUIRE(std::stod(same[i][2]) == 0.0);
        REQUIRE(std::stod(same[i][3]) == 0.0);
    }
    CHECK(std::stod(other.back()[2]) > 0.01);
}

TEST_CASE("measured motion touches nothing and moves no bit of a run") {
    const Choices plain = run_of("funnel", {{"count", "8"}, {"seconds", "2"}});
    Choices measured = plain;
    // In the way of everything that falls.
    for (std::size_t i = 0; i < plain.description.bodies.size(); ++i) {
        if (!plain.description.bodies[i].mass) continue;
        const Vector3 here(0, 1, 0), there(0.1, 1, 0);
        add_measured(measured.description, i,
                     {{0.0, {.body = i, .position = here}}, {1.5, {.body = i, .position = there}}});
    }
    Simulation alone(plain), beside(measured);
    const MeasuredErrors errors(beside.scene());
    while (alone.sample().step < 120) {
        alone.advance();
        beside.advance();
        CHECK(errors.at(beside).size() == (beside.sample().step <= 90 ? 8 : 0));
    }
    const auto& bodies = alone.scene().world.bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        CHECK(bodies[i].position == beside.scene().world.bodies[i].position);
        CHECK(bodies[i].linear_momentum == beside.scene().world.bodies[i].linear_momentum);
    }
    CHECK(alone.scene().contacts->colliders().size() == beside.scene().contacts->colliders().size());
}

TEST_CASE("between measured instants a body is expected on a straight line, at an even turn") {
    const Folder folder;
    folder.write("scene.json", R"({"version": 1, "name": "still", "bodies": [{"name": "ball", "shape": "sphere",
        "radius_m": 0.1, "mass_kg": 1}], "options": {"seconds": "1", "dt": "1/4", "measured": "ball.csv"}})");
    folder.write("ball.csv", "time_s,body,x_m,y_m,z_m,qw,qx,qy,qz\n0,0,0,0,0,1,0,0,0\r\n1,0,4,0,3,0,1,0,0\n");
    // Beside the scene file, wherever the program runs.
    require_success(folder, "mkdir other && cd other && pushfactor run ../scene.json --errors ../errors.csv");
    const auto errors = table_of(folder.read("errors.csv"));
    REQUIRE(errors.size() == 6);
    for (std::size_t i = 1; i < errors.size(); ++i) {
        const double time = 0.25 * static_cast<double>(i - 1);
        CHECK(std::stod(errors[i][2]) == Approx(5.0 * time).margin(1e-12));
        CHECK(std::stod(errors[i][3]) == Approx(180.0 * time).margin(1e-9));
    }
}

TEST_CASE("a scene with measured motion is the same scene as its file and as its saved state") {
    const Folder folder;
    folder.write("brick.json", brick_with(""));
    require_success(folder, "pushfactor run brick.json --trajectory b.csv > first.json");
    require_success(folder, "pushfactor scene brick.json --friction 0.1 --measured b.csv > both.json");
    require_success(folder, "pushfactor run both.json --errors e1.csv");
    require_success(folder, "pushfactor run brick.json --friction 0.1 --measured b.csv --errors e2.csv");
    CHECK(folder.read("e1.csv") == folder.read("e2.csv"));
    require_success(folder, "pushfactor run both.json --seconds 0.5 --save-state half.json");
    require_success(folder, "pushfactor run half.json --seconds 0.5 --errors e3.csv");
    // The same instants, which a resumed run counts from its own start.
    const auto whole = table_of(folder.read("e1.csv")), second = table_of(folder.read("e3.csv"));
    REQUIRE(second.size() == 52);
    for (std::size_t i = 1; i < second.size(); ++i) {
        CHECK(second[i][2] == whole[i + 50][2]);
        CHECK(second[i][3] == whole[i + 50][3]);
    }
}

TEST_CASE("a polyhedron has its measured motion where it is itself") {
    const Folder folder;
    const std::string run =
        "pushfactor run '" PUSHFACTOR_SOURCE_DIR "/assets/scenes/polyhedra.json' --seconds 0.5 ";
    require_success(folder, run + "--trajectory own.csv");
    require_success(folder, run + "--measured own.csv --errors e.csv");
    REQUIRE(table_of(folder.read("e.csv")).size() > 100);
    for (const auto& line : table_of(folder.read("e.csv"))) {
        if (line[0] != "time_s") CHECK(std::stod(line[2]) < 1e-9);
    }
}

TEST_CASE("moments of inertia are those that are given: a turn about an axis keeps its momentum") {
    const Folder folder;
    folder.write("brick.json", brick_with(""));
    const Simulation run(run_of((folder / "brick.json").string(), {{"start-kick", "off"}}));
    const pushfactor::engine::Body& body = run.scene().world.bodies[1];
    CHECK((body.angular_momentum - Vector3(0.06, 0.05, 0.08)).norm() < 1e-15);
    CHECK((angular_velocity(body) - Vector3(3, 1, 2)).norm() < 1e-14);
}

TEST_CASE("where no step is within the measured time, nothing is compared, and a warning says so") {
    const Folder folder;
    require_success(folder, "pushfactor run stack --seconds 0.1 --trajectory own.csv > plain.json");
    const Ended ended = shell(folder, "pushfactor run stack --seconds 0 --measured own.csv");
    const Json measured = parse_json(ended.out)["measured"];
    CHECK(measured["compared"] == 0);
    CHECK(measured["distance_m_mean"].is_null());
    CHECK(measured["angle_deg_largest"].is_null());
    CHECK(ended.err.find("stack: nothing was compared with the measured poses") != std::string::npos);
}

TEST_CASE("measured motion that cannot be is refused by field and line") {
    const Folder folder;
    folder.write("brick.json", brick_with(""));
    const auto refused = [&](const std::string& lines, const std::string& words) {
        folder.write("m.csv", "time_s,body,x_m,y_m,z_m,qw,qx,qy,qz\n" + lines);
        check_refused(folder, "pushfactor run brick.json --measured m.csv", words);
    };
    refused("", "must have poses of a body with a mass");
    refused("0,2,0,0,0,1,0,0,0\n", "line 2: body 2 must be one of the scene's, 0 to 1");
    refused("0,0,0,0,0,1,0,0,0\n", "line 2: body 0 (ground) must be one with a mass");
    refused("0.1,1,0,0,0,1,0,0,0\n", "line 2: body 1 (brick) must begin at 0 s, not 0.1");
    refused("0,1,0,0,0,1,0,0,0\n", "body 1 (brick) must have two poses at least");
    refused("0,1,0,0,0,1,0,0,0\n0,1,0,0,0,1,0,0,0\n", "line 3: the time of body 1 (brick) must be above");
    refused("0,1,0,0,0,1,0,0\n", "line 2: must be numbers");
    check_refused(folder, "pushfactor run brick.json --errors e.csv",
                  "--errors e.csv: must be of a scene with measured motion");

    const auto refused_body = [&](const std::string& more, const std::string& words) {
        folder.write("bad.json", brick_with(more));
        check_refused(folder, "pushfactor run bad.json", words);
    };
    refused_body(R"(, "measured_of": "ground")", "bodies[1].measured_of");
    refused_body(R"(}, {"name": "ghost", "shape": "sphere", "radius_m": 1, "static": true, "measured_of": "brick")",
                 "must be left out of a body without a motion");
    refused_body(R"(}, {"name": "ghost", "shape": "sphere", "radius_m": 1, "static": true,
                    "motion": {"velocity_m_per_s": [1, 0, 0]}, "measured_of": "ground")",
                 "must be the name of a body with a mass");
    folder.write("bad.json", replaced(brick_with(""), "[0.02, 0.05, 0.04]", "[0.02, 0.07, 0.04]"));
    check_refused(folder, "pushfactor run bad.json", "none larger than the sum of the others");
}
