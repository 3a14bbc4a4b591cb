// Films drawn in shares: frames and video are those of one process.
#include "tests/catch.h"
#include "tests/demos/program.h"

#include <map>

using namespace pushfactor::tests;

namespace {

namespace fs = std::filesystem;

// Frames and config.json by name.
std::map<std::string, std::string> film_in(const Folder& folder, const std::vector<std::string>& parts) {
    std::map<std::string, std::string> files;
    for (const std::string& part : parts) {
        for (const auto& entry : fs::directory_iterator(folder / part)) {
            const std::string name = entry.path().filename();
            if (name != "summary.json") files[name] = folder.read(part + "/" + name);
        }
    }
    return files;
}

const std::string small = " --seconds 0.25 --size 64x36 ";

}  // namespace

TEST_CASE("frames from a trajectory in shares are those of the run, with moved bodies and fitted cameras too") {
    const std::string assets = PUSHFACTOR_SOURCE_DIR "/assets/scenes/";
    for (const std::string& scene : {std::string("platonic --count 10 --camera fit"), assets + "moved.json",
                                     assets + "rover.json --camera orbit:20"}) {
        INFO(scene);
        const Folder folder;
        require_success(folder, "pushfactor render " + scene + small + "--out whole");
        const std::string run = scene.substr(0, scene.find(" --camera"));
        require_success(folder,
                        "pushfactor run " + run + " --seconds 0.25 --fps 60 --trajectory t.csv --summary s");
        for (const char* const shard : {"3/3", "1/3", "2/3"}) {
            require_success(folder, "pushfactor render " + scene + small +
                                        "--from-trajectory t.csv --out part --shard " + shard);
        }
        CHECK(film_in(folder, {"part"}) == film_in(folder, {"whole"}));
        CHECK(film_in(folder, {"whole"}).size() == 1 + 16);
    }
}

TEST_CASE("shards that simulate draw forces as one process does, and each only its frames") {
    const Folder folder;
    const std::string film = "pushfactor render stack --overlay forces" + small;
    require_success(folder,
                    film + "--out whole && " + film + "--out a --shard 1/2 && " + film + "--out b --shard 2/2");
    CHECK(film_in(folder, {"a", "b"}) == film_in(folder, {"whole"}));
    CHECK(film_in(folder, {"a"}).size() == 1 + 8);
    CHECK(folder.read("a/summary.json") == folder.read("whole/summary.json"));
}

TEST_CASE("a video joined from folders of frames is the one that is made while they are drawn") {
    const Folder folder;
    folder.write("ffmpeg", "#!/bin/sh\nfor video; do :; done\ncat >\"$video\"\n");
    fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
    const std::string path = "export PATH=\"$PWD:$PATH\"; ";
    const std::string film = "pushfactor render stack" + small;
    require_success(folder, path + film + "--out whole --video whole.mp4");
    require_success(folder, film + "--out a --shard 1/2 && " + film + "--out b --shard 2/2");
    require_success(folder, path + "pushfactor render --join b a --video joined.mp4");
    CHECK(folder.read("joined.mp4").size() == 16 * 64 * 36 * 3);
    CHECK(folder.read("joined.mp4") == folder.read("whole.mp4"));

    fs::remove(folder / "b/frame_000003.png");
    const Ended ended = shell(folder, path + "pushfactor render --join a b --video other.mp4");
    CHECK(ended.status == 1);
    CHECK(ended.err == "pushfactor: --join: 1 of 16 frames are missing: frame_000003.png\n");
    CHECK(!fs::exists(folder / "other.mp4"));
    require_success(folder, "pushfactor render funnel" + small + "--out c --shard 1/2");
    check_refused(folder, path + "pushfactor render --join a c --video other.mp4", "--join: must be of one film");
    check_refused(folder, path + "pushfactor render --join . --video other.mp4",
                  "--join .: must have a config.json");
    check_refused(folder, path + "pushfactor render --join a", "--join: must be with --video");
    check_refused(folder, path + "pushfactor render stack --join a --video x.mp4",
                  "--join stack: must have a config.json");
}

TEST_CASE("what poses do not tell, and a trajectory of another run, are refused in one line") {
    const Folder folder;
    require_success(folder, "pushfactor run stack --seconds 0.1 --trajectory t.csv --summary s");
    folder.write("words.csv", "time,body\n");
    folder.write("torn.csv", folder.read("t.csv").substr(0, 700));
    const std::string render = "pushfactor render stack --seconds 0.1 --size 64x36 --out out --from-trajectory ";
    for (const char* const overlay : {"forces", "contacts", "push", "islands", "velocities"}) {
        check_refused(folder, render + "t.csv --overlay " + overlay,
                      std::string("--overlay ") + overlay + ": must not be with --from-trajectory");
    }
    check_refused(folder, render + "t.csv --ghosts 0.05", "--ghosts: must not be with --from-trajectory");
    check_refused(folder, render + "t.csv --samples 4 --shutter 0.5",
                  "--shutter: must not be with --from-trajectory");
    check_refused(folder, render + "t.csv --csv x.csv", "--csv x.csv: must be without --from-trajectory");
    check_refused(folder, render + "t.csv --compare beta=0.1,0.2", "must be for one run, not with --compare");
    // Some of these make a difference only after the first frames.
    for (const char* const option : {"--friction 0.1", "--preset paper", "--count 4", "--dt 1/120 --fps 120"}) {
        check_refused(folder, render + "t.csv " + option, "t.csv: must be of the same scene and options, but for");
    }
    require_success(folder,
                    "pushfactor scene stack --preset default > other-looks.json && pushfactor render "
                    "other-looks.json --seconds 0.05 --threads 1 --size 64x36 --from-trajectory t.csv");
    // Files of earlier versions do not say of what they are.
    require_success(folder, "sed 's/,[^,]*$//' t.csv > old.csv");
    check_refused(folder, render + "old.csv --count 4",
                  "must have one line for each body that moves, 4 at 0 s, not 5");
    check_refused(folder, render + "old.csv --gap 0.05", "must be of the same scene and options: body ");
    check_refused(folder, render + "old.csv --dt 1/120 --fps 120", "must have the poses at ");
    check_refused(folder, render + "words.csv", "line 1: must begin with time_s,body,");
    check_refused(folder, render + "torn.csv", "torn.csv: ");
    check_refused(folder, render + "nowhere.csv", "nowhere.csv: cannot be read");
    check_refused(folder, "pushfactor render stack --shard 3/2 --out out", "--shard 3/2: must be K/N");
    check_refused(folder, "pushfactor render stack --shard 1/2 --video x.mp4", "must be with --join");
}
