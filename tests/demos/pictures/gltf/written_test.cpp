// glTF files of the named scenes, and how files are written.
#include "demos/options/named_run.h"
#include "tests/demos/pictures/gltf/glb_runs.h"

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::tests;

TEST_CASE(
    "a glTF file of every named scene has the parts that the format wants, and its poses are the trajectory's") {
    double worst = 0.0;
    for (const std::string& scene : named_scenes()) {
        INFO(scene);
        const Written written(scene);
        const Glb glb(written.folder.read("a.glb"));
        check_sound(glb);
        const std::vector<BodyDescription> bodies = run_of(scene, {}).description.bodies;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            INFO(bodies[i].name);
            const std::size_t node = glb.node(bodies[i].name);
            CHECK(glb.json["nodes"][node].contains("mesh"));
            const auto line = written.trajectory.find(static_cast<int>(i));
            if (line == written.trajectory.end()) {
                CHECK(!glb.sampler(node, "translation"));
                CHECK(!glb.sampler(node, "rotation"));
                continue;
            }
            REQUIRE(line->second.size() == 31);
            for (std::size_t n = 0; n < 31; n += 5) {
                const double time = static_cast<double>(n) / 60.0;
                worst = std::max(
                    worst, apart(line->second[n], glb.vector(node, "translation", time), glb.rotation(node, time)));
            }
        }
    }
    CHECK(worst < 1e-6);
}

TEST_CASE("run and render write the same glTF file, whatever the threads, and a picture does not change it",
          "[threads]") {
    const Folder folder;
    REQUIRE(shell(folder, "pushfactor run stack --seconds 0.5 --overlay forces --glb a.glb --threads 1").status ==
            0);
    REQUIRE(shell(folder, "pushfactor run stack --seconds 0.5 --overlay forces --glb b.glb --threads 2").status ==
            0);
    REQUIRE(
        shell(folder, "pushfactor render stack --seconds 0.5 --overlay forces --glb c.glb --size 64x36 --threads 1")
            .status == 0);
    Glb a(folder.read("a.glb")), b(folder.read("b.glb"));
    CHECK(folder.read("a.glb") == folder.read("c.glb"));
    CHECK(a.binary == b.binary);
}

TEST_CASE("a run that stops early leaves a glTF file of the frames so far, and a failed one none") {
    const Folder folder;
    folder.write("bad.json", R"({"version": 1, "contacts": false, "bodies": [
        {"name": "ball", "shape": "sphere", "radius_m": 1, "mass_kg": 1, "velocity_m_per_s": [1, 0, 0]}],
        "forces": [{"body": "ball", "force_n": [1e308, 0, 0], "from_s": 0.1}]})");
    const Ended ended = shell(folder, "pushfactor run bad.json --seconds 1 --glb a.glb");
    INFO(ended.err);
    CHECK(ended.status == 5);
    CHECK_THAT(ended.err, Catch::Contains("a.glb holds the run up to step"));
    const Glb glb(folder.read("a.glb"));
    check_sound(glb);
    const std::size_t keys = glb.count((*glb.sampler(glb.node("ball"), "translation"))["input"]);
    CHECK(keys > 3);
    CHECK(keys < 60);
    CHECK(shell(folder, "pushfactor run stack --seconds 0.1 --glb /proc/no/a.glb").status == 4);
    for (const std::string& file : folder.files()) CHECK(file.find(".partial") == std::string::npos);
}

TEST_CASE("what a glTF file cannot hold is refused in one line") {
    check_refused("run stack --glb a.gltf", "--glb a.gltf: must end in .glb");
    check_refused("run stack --glb -", "--glb -: must end in .glb");
    check_refused("run stack --glb a.glb --overlay islands",
                  "--overlay islands: must be of pictures; a glTF file does not show it");
    check_refused("run pendulum-wave --glb a.glb --overlay contacts", "--overlay contacts: scene pendulum-wave");
    check_refused("run stack --glb a.glb --fps 7", "--fps 7: a frame must be a whole number of steps");
    check_refused("run stack --glb a.glb --seconds 1e6", "must have at most 4194304 frames, not 60000001");
    check_refused("run funnel --count 1000 --glb a.glb --seconds 5000", "must be at most 4.29 GB");
    check_refused("render stack --glb a.glb --at 1", "--glb a.glb: must be of a sequence, not of stills (--at)");
    check_refused("render stack --glb a.glb --compare push=none,persistent",
                  "--glb a.glb: must be for one run, not with --compare");
    check_refused("render stack chain --glb a.glb", "--glb a.glb: must be for one scene at a time");
}
