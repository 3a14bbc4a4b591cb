// Bodies and bars in glTF files, against what the renderer draws.
#include "demos/options/named_run.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/gltf/tracks.h"
#include "tests/demos/pictures/gltf/glb_runs.h"
#include "tests/random.h"

#include <cmath>
#include <set>

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::tests;
using pictures::gltf::Segment;

TEST_CASE("meshes in a glTF file grow neither with the frames of a run nor with bodies of the same shape") {
    const auto run = [](const std::string& count, const std::string& seconds) {
        return recorded(run_of("funnel", {{"count", count}, {"seconds", seconds}}));
    };
    const Glb few = run("20", "0.1"), longer = run("20", "0.5"), more = run("60", "0.1");
    CHECK(few.json["meshes"] == longer.json["meshes"]);
    CHECK(few.json["bufferViews"][0] == longer.json["bufferViews"][0]);
    CHECK(few.json["bufferViews"][1] == longer.json["bufferViews"][1]);
    // One ball, once in each of the six colours.
    for (const Glb* glb : {&few, &more}) {
        std::set<int> positions;
        std::size_t balls = 0;
        for (const Json& mesh : glb->json["meshes"]) {
            if (mesh["name"] != "ball") continue;
            ++balls;
            for (const Json& part : mesh["primitives"]) positions.insert(part["attributes"]["POSITION"].get<int>());
        }
        CHECK(balls == 6);
        CHECK(positions.size() == 1);
    }
}

TEST_CASE("keys of a glTF file follow the frame rate, and bodies that stay where they are have none") {
    Choices choices = run_of("stack", {{"seconds", "0.5"}});
    choices.frames.fps = Rational{20, 1};
    const Glb glb = recorded(choices);
    const Json* const sampler = glb.sampler(glb.node("cube 2"), "translation");
    REQUIRE(sampler);
    const std::vector<double> times = glb.numbers((*sampler)["input"]);
    REQUIRE(times.size() == 11);
    for (std::size_t n = 0; n < times.size(); ++n)
        CHECK(times[n] == static_cast<float>(static_cast<double>(n) / 20.0));
    CHECK(!sampler->contains("interpolation"));  // LINEAR
    CHECK(!glb.sampler(glb.node("ground"), "translation"));
    CHECK(!glb.sampler(glb.node("cube 2"), "rotation"));  // it falls upright
    CHECK(glb.vector(glb.node("cube 1"), "translation", 0.0) == Vector3(0, 2, 0));

    choices.frames.play_speed = Rational{1, 3};
    const Glb slow = recorded(choices);
    const Json* const slowed = slow.sampler(slow.node("cube 2"), "translation");
    REQUIRE(slowed);
    CHECK(slow.numbers((*slowed)["input"]).size() == 31);
    CHECK(slow.vector(slow.node("cube 2"), "translation", 1.5) ==
          glb.vector(glb.node("cube 2"), "translation", 0.5));
}

TEST_CASE("bars in a glTF file join the points that the renderer joins, and turn by the shortest way") {
    for (const char* const scene : {"pendulum-wave", "rover"}) {
        INFO(scene);
        const Choices choices = run_of(scene, {{"seconds", "0.5"}});
        std::vector<std::vector<renderer::Bar>> frames;
        const Glb glb = recorded(choices, [&](const Simulation& run) {
            frames.push_back(pictures::draw_list(run.scene(), run.scene().view).bars);
        });
        REQUIRE(!frames.front().empty());
        double worst = 0.0;
        for (std::size_t i = 0; i < frames.front().size(); ++i) {
            const std::size_t node = glb.node("bar " + std::to_string(i + 1));
            for (const std::size_t n : {std::size_t{0}, frames.size() / 2, frames.size() - 1}) {
                const double time = static_cast<double>(n) * choices.settings.dt.value();
                const renderer::Bar& bar = frames[n][i];
                const Vector3 scale = glb.vector(node, "scale", time);
                const Vector3 half = glb.rotation(node, time) * Vector3(0, scale.y() - bar.radius, 0);
                const Vector3 middle = glb.vector(node, "translation", time);
                const Vector3 from(bar.from.x, bar.from.y, bar.from.z), to(bar.to.x, bar.to.y, bar.to.z);
                worst = std::max({worst, (middle - half - from).norm(), (middle + half - to).norm()});
                CHECK(scale.x() == Approx(bar.radius));
                CHECK(scale.z() == Approx(bar.radius));
            }
        }
        CHECK(worst < 5e-6);
    }
}

TEST_CASE("a stretched mesh ends at its points and does not turn more than its direction") {
    Random random(3);
    std::vector<std::optional<Segment>> keys;
    for (int i = 0; i < 200; ++i) {
        const Vector3 from = random.vector(-1, 1), to = random.vector(-1, 1);
        keys.push_back(i % 7 == 3 ? std::nullopt : std::optional(Segment{from, to}));
    }
    using Stretch = pictures::gltf::Stretch;
    const auto placed = pictures::gltf::stretched(
        keys, {.origin = Stretch::Origin::start, .per_length = Vector3::Ones(), .fixed = Vector3::Zero()});
    REQUIRE(placed.scales.size() == 3 * keys.size());
    Quaternion last = Quaternion::Identity();
    Vector3 along = Vector3::UnitY();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const auto vector = [&](const std::vector<float>& v) {
            return Vector3(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
        };
        const Quaternion q(Eigen::Vector4f(&placed.rotations[4 * i]).cast<double>());
        if (!keys[i]) {
            CHECK(vector(placed.scales) == Vector3::Zero());
            CHECK(q.angularDistance(last) < 1e-6);
            continue;
        }
        CHECK((vector(placed.translations) - keys[i]->from).norm() < 1e-6);
        const Vector3 tip = vector(placed.translations) + q * Vector3(0, vector(placed.scales).y(), 0);
        CHECK((tip - keys[i]->to).norm() < 2e-6);
        const Vector3 direction = (keys[i]->to - keys[i]->from).normalized();
        CHECK(q.angularDistance(last) ==
              Approx(std::acos(std::clamp(direction.dot(along), -1.0, 1.0))).margin(1e-3));
        last = q;
        along = direction;
    }
}
