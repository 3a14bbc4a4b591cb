// What render adds to a picture, seen from outside: panels, overlays, captions, videos.
#include "tests/catch.h"
#include "tests/demos/program.h"

using namespace pushfactor::tests;

namespace {

Ended render(const Folder& folder, const std::string& arguments) {
    return shell(folder, "pushfactor render " + arguments + " --out frames --size 320x180");
}

// Stands in for ffmpeg: writes what it is fed to the file that it is asked for.
void fake_ffmpeg(const Folder& folder, const std::string& body) {
    folder.write("ffmpeg", "#!/bin/sh\nfor video; do :; done\n" + body + "\n");
    std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
}

}  // namespace

TEST_CASE("panels, overlays, cameras and captions each change the picture, and equal options give equal bytes") {
    const std::vector<std::string> variants{"",
                                            "--caption off",
                                            "--compare push=none,persistent",
                                            "--overlay velocities",
                                            "--camera orbit:30",
                                            "--camera fit",
                                            "--samples 3"};
    std::vector<std::string> pictures;
    for (const std::string& variant : variants) {
        const Folder folder;
        const std::string arguments = "intersecting-stack --seconds 0.5 --at 0.5 " + variant;
        const Ended ended = render(folder, arguments);
        INFO(variant << ": " << ended.err);
        REQUIRE(ended.status == 0);
        pictures.push_back(folder.read("frames/at_0.5s.png"));
        const Folder again;
        REQUIRE(shell(again,
                      "pushfactor render --config '" + (folder / "frames/config.json").string() + "' --out frames")
                    .status == 0);
        CHECK(again.read("frames/at_0.5s.png") == pictures.back());
    }
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            INFO(variants[i] << " and " << variants[j]);
            CHECK(pictures[i] != pictures[j]);
        }
    }
}

TEST_CASE("the summary of compared runs has one of each, and their states are those of the runs alone") {
    const Folder folder;
    REQUIRE(render(folder, "stack --seconds 1 --at 1 --compare push=none,persistent").status == 0);
    const std::string both = folder.read("frames/summary.json");
    for (const char* push : {"none", "persistent"}) {
        const std::string alone = run_program(std::string("run stack --seconds 1 --push ") + push).out;
        const std::string hash = alone.substr(alone.find("state_hash"), 32);
        CHECK(both.find(hash) != std::string::npos);
    }
}

TEST_CASE("options that cannot go together are refused before anything is written") {
    const Folder folder;
    const auto refused = [&](const std::string& arguments, const std::string& words) {
        const Ended ended = render(folder, arguments);
        INFO(arguments << ": " << ended.err);
        CHECK(ended.status == 2);
        CHECK(ended.err.find(words) != std::string::npos);
    };
    refused("stack --compare push=none,persistent --csv x.csv", "--csv x.csv: must be for one run");
    refused("stack --compare dt=1/60,1/50", "rates that fit");
    refused("stack --video x.avi", "--video x.avi: must end in .mp4, .webm or .gif");
    refused("stack --video x.mp4 --at 1", "--video x.mp4: must be of a sequence");
    refused("stack --frames off", "--frames off: must come with --video");
    refused("stack funnel --video x.mp4", "--video x.mp4: must be for one scene at a time");
    refused("pendulum-wave --overlay contacts --at 0", "has no contacts, so there is nothing to show");
    refused("stack --overlay contact", "--overlay contact: must be some of contacts");
    refused("stack --samples 1000", "--samples 1000: must be a whole number from 1 to 256");
    refused("stack --camera sideways", "--camera sideways: must be a camera file");
    folder.write("camera.json", R"({"eye_m": [1, 2, 3], "targt_m": [0, 0, 0]})");
    refused("stack --camera camera.json", "targt_m: unknown key; did you mean target_m?");
    CHECK(!std::filesystem::exists(folder / "frames/config.json"));
}

TEST_CASE("a video is fed every frame, beside the PNG files or instead of them") {
    for (const bool png : {true, false}) {
        const Folder folder;
        fake_ffmpeg(folder, "cat >\"$video\"");
        const Ended ended = shell(folder,
                                  "PATH=.:$PATH pushfactor render stack --seconds 0.5 --fps 10 --size 64x36 "
                                  "--out frames --video film.mp4" +
                                      std::string(png ? "" : " --frames off"));
        INFO(ended.err);
        REQUIRE(ended.status == 0);
        CHECK(std::filesystem::file_size(folder / "film.mp4") == 6 * 64 * 36 * 3);
        CHECK(std::filesystem::exists(folder / "frames/frame_000005.png") == png);
    }
}

TEST_CASE("without ffmpeg the frames are kept, wanted or not, and the message says what to install") {
    const Folder folder;
    const Ended ended = shell(folder,
                              "PATH=/nowhere pushfactor render stack --seconds 0.1 --fps 10 --size 64x36 "
                              "--out frames --video film.mp4 --frames off");
    CHECK(ended.status == 4);
    CHECK(ended.err.find("ffmpeg is not installed (Debian: apt install ffmpeg); the frames are in frames") !=
          std::string::npos);
    CHECK(std::filesystem::exists(folder / "frames/frame_000001.png"));
    CHECK(!std::filesystem::exists(folder / "film.mp4"));
}

TEST_CASE("an ffmpeg that fails ends the run with its own words and leaves no video") {
    const Folder folder;
    fake_ffmpeg(folder, "echo 'Unknown encoder' >&2; exit 1");
    const Ended ended = shell(folder,
                              "PATH=.:$PATH pushfactor render stack --seconds 1 --size 64x36 --out frames "
                              "--video film.mp4");
    CHECK(ended.status == 4);
    CHECK(ended.err.find("film.mp4: ffmpeg ended with status 1: Unknown encoder") != std::string::npos);
    CHECK(!std::filesystem::exists(folder / "film.mp4"));
    CHECK(!std::filesystem::exists(folder / "film.partial.mp4"));
}
