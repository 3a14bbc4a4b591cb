// The report on measured motion: closed forms, the measured tosses, what symmetry says of dice, and its files.
#include "demos/base/platform/assets.h"
#include "demos/base/text/errors.h"
#include "demos/reports/reality/sections.h"
#include "demos/scenes/scene_file.h"
#include "tests/catch.h"
#include "tests/demos/csv.h"
#include "tests/demos/pages/check_page.h"
#include "tests/demos/program.h"
#include "tests/texts.h"

#include <cmath>
#include <numbers>

using namespace pushfactor::demos;
using namespace pushfactor::demos::reports::reality;
using namespace pushfactor::tests;
using pushfactor::engine::Quaternion;
using pushfactor::engine::Vector3;

TEST_CASE(
    "motions with a closed form are it to 1e-3 under the cone, and the paper's friction is off where forces "
    "change") {
    for (const ClosedForm& form : closed_forms()) {
        INFO(form.name);
        CHECK(std::abs(form.computed(FrictionModel::cone) - form.exact) < 1e-3);
    }
    const ClosedForm& rocking = closed_forms().back();
    CHECK(std::abs(rocking.computed(FrictionModel::paper) - rocking.exact) > 0.1);
}

TEST_CASE("the measured tosses are all there, turn as they say they do and fall") {
    const std::vector<Toss> tosses = read_tosses(asset_folder("measured"));
    REQUIRE(tosses.size() == 570);
    std::size_t frames = 0;
    for (const Toss& toss : tosses) frames += toss.frames.size();
    CHECK(frames == 59953);
    for (std::size_t t = 0; t < tosses.size(); t += 50) {
        INFO(t);
        const Toss& toss = tosses[t];
        // Of a straight line through the first five poses; the authors' velocities are smoothed, too.
        const Restart start = restart(toss, 2);
        const double from_start = 2.0 / frames_per_second;
        CHECK((start.velocity - toss.start.velocity - from_start * Vector3(0, -9.81, 0)).norm() < 0.15);
        CHECK((start.angular_velocity - toss.start.angular_velocity).norm() < 1.0);
        CHECK(!bounces(toss, -0.0012).empty());
    }
}

TEST_CASE("a toss in flight is a parabola, and one onto the board stays above it") {
    const Pose start{Vector3(0, 1, 0), Quaternion::Identity()};
    const Law law{0.18, 0.1, 0.0};
    const std::vector<Pose> poses = computed({start, Vector3(1, 2, 0), Vector3(0, 3, 0)}, law, 200);
    const double time = 50.0 / frames_per_second;
    CHECK((poses[50].position - Vector3(time, 1.0 + 2.0 * time - 0.5 * 9.81 * time * time, 0)).norm() < 1e-9);
    CHECK(std::abs(poses[50].orientation.angularDistance(start.orientation) - 3.0 * time) < 1e-9);
    for (const Pose& pose : poses) CHECK(pose.position.y() > 0.5 * edge - 1e-3);
    CHECK(upper_face(poses.back().orientation) == 2);
}

TEST_CASE("the scene of a toss is what is judged, with its measured motion") {
    const Toss toss = read_tosses(asset_folder("measured")).at(3);
    const Law law{0.18, 0.1, -0.0012};
    const PoseError judged = mean_error(toss, computed(toss.start, law, toss.frames.size()));
    const Folder folder;
    folder.write("toss.json", scene_file_text(scene_of(toss, law)));
    require_success(folder, "pushfactor run toss.json --errors errors.csv");
    double distance = 0.0, angle = 0.0;
    const auto errors = table_of(folder.read("errors.csv"));
    REQUIRE(errors.size() == toss.frames.size() + 1);
    for (std::size_t i = 2; i < errors.size(); ++i) {
        distance += std::stod(errors[i][2]) / static_cast<double>(errors.size() - 2);
        angle += std::stod(errors[i][3]) / static_cast<double>(errors.size() - 2);
    }
    CHECK(distance / edge == Approx(judged.position).epsilon(1e-9));
    CHECK(angle == Approx(judged.angle).epsilon(1e-9));
}

TEST_CASE("one law of contact follows the tosses to 13.5 % of an edge, and another friction does not") {
    const std::vector<Toss> tosses = read_tosses(asset_folder("measured"));
    const auto error = [&tosses](double friction) {
        std::vector<double> all;
        for (std::size_t t = 1; t < tosses.size(); t += 2) {
            const Toss& toss = tosses[t];
            const Law law{friction, 0.1, -0.0012};
            all.push_back(mean_error(toss, computed(toss.start, law, toss.frames.size())).position);
        }
        return mean_of(all).value;
    };
    CHECK(error(0.18) < 0.135);
    CHECK(error(0.14) > 0.2);
    CHECK(error(0.22) > 0.2);
}

TEST_CASE("a cube shows each pair of faces as often, a plate and a rod hardly ever their sides") {
    const Law law{0.3, 0.5};
    const auto share = [&](double length) { return square_faces(length, law, 1000, [] {}) / 1000.0; };
    const double deviation = std::sqrt(1.0 / 3.0 * 2.0 / 3.0 / 1000.0);
    CHECK(std::abs(share(1.0) - 1.0 / 3.0) < 3.0 * deviation);
    CHECK(share(0.1) > 0.98);
    CHECK(share(5.0) < 0.02);
}

TEST_CASE("measured packings are those of spheres and the five regular solids") {
    const std::vector<MeasuredPacking> packings = read_packings();
    REQUIRE(packings.size() == 6);
    CHECK(!packings.front().loose);
    CHECK(packings[2].solid == "cube");
    CHECK(packings[2].loose == 0.54);
    for (const MeasuredPacking& packing : packings) CHECK(packing.dense > packing.loose.value_or(0.5));
}

TEST_CASE("shaking packs spheres closer than pouring, and neither more than any packing can") {
    const Packing spheres = packed("sphere", {.width = 6.0, .bodies = 300, .friction = 0.5, .shakes = 20}, [] {});
    CHECK(spheres.loose.value > 0.5);
    CHECK(spheres.dense.value > spheres.loose.value);
    CHECK(spheres.dense.value < std::numbers::pi / std::sqrt(18.0));
    // Of eight frictions from 0.46 to 0.53 the mean of both was 0.015 to 0.022, that of one of them up to 0.03.
    CHECK(0.5 * (spheres.loose.error + spheres.dense.error) < 0.025);
}

TEST_CASE("confidence of a share is that of Wilson's paper, and the error of a mean that of its textbook") {
    const auto [low, high] = confidence(0.5, 100);
    CHECK(std::abs(low - 0.4038) < 1e-4);
    CHECK(std::abs(high - 0.5962) < 1e-4);
    const Mean mean = mean_of({1.0, 2.0, 3.0});
    CHECK(mean.value == 2.0);
    CHECK(std::abs(mean.error - 1.0 / std::sqrt(3.0)) < 1e-15);
}

TEST_CASE("a measured file that is not what it must be is refused by name and line") {
    const Folder folder;
    folder.write("a.csv", "x,y\n1,2\n3\n");
    folder.write("b.csv.gz", "no archive");
    CHECK_THROWS_WITH(numbers_of(folder / "a.csv", "x,z"), Catch::Contains("must begin with x,z"));
    CHECK_THROWS_WITH(numbers_of(folder / "a.csv", "x,y"), Catch::Contains("line 3: must be 2 numbers"));
    CHECK_THROWS_WITH(numbers_of(folder / "b.csv.gz", "x,y"), Catch::Contains("is damaged"));
    CHECK_THROWS_WITH(numbers_of(folder / "c.csv", "x,y"), Catch::Contains("cannot be read"));
}

TEST_CASE("the quick report makes its page, tables and replays of tosses") {
    const Folder folder;
    const Ended ended = shell(folder, "pushfactor report reality --quick --only closed-forms,tosses --out .");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    check_page(folder.read("index.html"));
    for (const char* name : {"closed_forms.csv", "toss_results.csv", "toss_fit.csv", "toss_bounces.csv",
                             "tosses.csv", "tosses/best.html", "tosses/worst.json"}) {
        INFO(name);
        CHECK(std::filesystem::exists(folder / name));
    }
    CHECK(!std::filesystem::exists(folder / "dice.csv"));
}
