// What render adds to a picture: panels, overlays, captions, videos.
#include "demos/base/text/json.h"
#include "renderer/images/difference.h"
#include "renderer/images/read_png.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

using namespace pushfactor::tests;
using pushfactor::demos::Json;
using pushfactor::demos::parse_json;

namespace {

// A frame has the mark of its film, and a still has none.
pushfactor::renderer::Image image_in(const Folder& folder, const std::string& name) {
    const std::string bytes = folder.read(name);
    return pushfactor::renderer::decode_png(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
}

Ended render(const Folder& folder, const std::string& arguments) {
    return shell(folder, "pushfactor render " + arguments + " --out frames --size 320x180");
}

// A fake ffmpeg: copies its input to the output file.
void fake_ffmpeg(const Folder& folder, const std::string& body) {
    folder.write("ffmpeg", "#!/bin/sh\nfor video; do :; done\n" + body + "\n");
    std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
}

}  // namespace

TEST_CASE("panels, overlays, cameras and captions each change the picture, and equal options give equal bytes") {
    const std::vector<std::string> variants{"",
                                            "--caption off",
                                            "--compare push=none,persistent",
                                            "--overlay contacts",
                                            "--camera orbit:30",
                                            "--camera scene",
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

TEST_CASE("captions and legends cross neither panels nor each other, and ghosts have a legend") {
    const Folder folder;
    const auto differing = [&](const std::string& with, const std::string& without) {
        const pushfactor::renderer::ImageDifference difference(image_in(folder, with + "/at_0.5s.png"),
                                                               image_in(folder, without + "/at_0.5s.png"));
        return difference.pixels_above(0);
    };
    const std::string render = "pushfactor render intersecting-stack --at 0.5 --size 640x360 --camera scene ";
    const std::string panels = render + "--compare push=none,persistent,single-frame ";
    require_success(folder, panels + "--overlay contacts,forces --out panels");
    // Below the panels there is nothing but letters on white.
    const auto sheet = image_in(folder, "panels/at_0.5s.png");
    const auto white_from = [&](int x) {
        int y = sheet.height;
        while (y > 0 && sheet.pixel(x, y - 1)[0] == 255) --y;
        return y;
    };
    CHECK(white_from(2) < sheet.height - 30);
    CHECK(white_from(2) == white_from(sheet.width - 3));

    require_success(folder, render +
                                "--overlay contacts,forces --out long --preset paper --beta 0.31 --slop 0.0011 "
                                "--margin 0.0123 --iterations 31 --max-push-speed 12.3456789 --warm-start on");
    require_success(folder, render +
                                "--overlay contacts,forces --out longer --preset paper --beta 0.31 --slop 0.0011 "
                                "--margin 0.0123 --iterations 31 --max-push-speed 12.3456789 --warm-start on "
                                "--threads 1");
    CHECK(differing("long", "longer") == 0);  // what is cut is not under the legend

    // Panels that are alike but for their names, which do not fit whole: the values are told apart.
    require_success(folder,
                    "pushfactor render stack --at 0.5 --camera scene --size 160x90 --out names --compare "
                    "max-push-speed=1111111,2111111");
    const auto names = image_in(folder, "names/at_0.5s.png");
    int different = 0;
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 79; ++x) different += names.pixel(x, y) == names.pixel(x + 81, y) ? 0 : 1;
    }
    CHECK(different > 4);

    require_success(folder, render + "--ghosts 0.5 --out ghosts");
    require_success(folder, render + "--out plain");
    CHECK(differing("ghosts", "plain") > 100);
}

TEST_CASE("the summary of compared runs has one of each, and their states are those of the runs alone") {
    const Folder folder;
    // Two renderers in one process: the leak checker crashes when it inspects the memory of the driver's ended
    // threads.
    REQUIRE(shell(folder,
                  "export LSAN_OPTIONS=\"$LSAN_OPTIONS:use_tls=0\"; pushfactor render stack --seconds 1 --at 1 "
                  "--compare push=none,persistent --out frames --size 320x180")
                .status == 0);
    const std::string both = folder.read("frames/summary.json");
    for (const char* push : {"none", "persistent"}) {
        const std::string alone = run_program(std::string("run stack --seconds 1 --push ") + push).out;
        const std::string hash = alone.substr(alone.find("state_hash"), 32);
        CHECK(both.find(hash) != std::string::npos);
    }
}

TEST_CASE("stills end the run at the last instant that is asked for, and are those of the whole run") {
    for (const auto& [at, steps] : {std::pair{"0", 0}, std::pair{"0.5,0.25", 30}}) {
        const Folder folder;
        const Ended ended =
            render(folder, std::string("stack --camera scene --seconds 1000000 --csv steps.csv --at ") + at);
        INFO(at << ": " << ended.err);
        REQUIRE(ended.status == 0);
        CHECK(parse_json(folder.read("frames/summary.json"))["steps"] == steps);
        CHECK(lines_of(folder.read("steps.csv")).size() == static_cast<std::size_t>(1 + steps));
        const Folder whole;
        REQUIRE(render(whole, std::string("stack --camera scene --seconds 1 --at 0.5,1,") + at).status == 0);
        const std::string name = std::string(at) == "0" ? "frames/at_0s.png" : "frames/at_0.5s.png";
        CHECK(folder.read(name) == whole.read(name));
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
    refused("stack --compare count=1,2 --count 3", "--count 3: must be without --compare count");
    refused("stack --compare preset=paper,exact --preset paper",
            "--preset paper: must be without --compare preset");
    refused("stack --compare push=none,none", "2 to 16 different values");
    refused("stack --compare threads=1,2", "cannot compare threads");
    refused("stack --at 0,1 --ghosts 0,2", "--ghosts 2: must not be after the last picture, which is at 1 s");
    refused("stack --camera orbit:20,orbit:30", "each once, with scene or a file");
    refused("stack --overlay forces,forces", "each once, with islands or rest");
    refused("stack --video x.avi", "--video x.avi: must end in .mp4, .webm or .gif");
    refused("stack --video x.mp4 --at 1", "--video x.mp4: must be of a sequence");
    refused("stack --frames off", "--frames off: must be with --video");
    refused("stack funnel --video x.mp4", "--video x.mp4: must be for one scene at a time");
    refused("pendulum-wave --overlay contacts --at 0", "has no contacts, so there is nothing to show");
    refused("stack --overlay velocities:1e-300 --at 0",
            "a scale like forces:50, trails seconds, from 1e-12 to 1e12");
    refused("pendulum-wave --count 121 --at 0", "count 121: must be at most 120 at this amplitude");
    refused("pendulum-wave --count 120 --amplitude 80 --at 0", "count 120: must be at most 111 at this amplitude");
    refused("stack --overlay contact", "--overlay contact: must be a comma-separated list of contacts");
    refused("stack --samples 1000", "--samples 1000: must be a whole number from 1 to 256");
    refused("stack --camera sideways", "--camera sideways: must be scene, a camera file");
    folder.write("camera.json", R"({"eye_m": [1, 2, 3], "targt_m": [0, 0, 0]})");
    refused("stack --camera camera.json", "targt_m: unknown key; did you mean target_m?");
    folder.write("camera.json", R"({"eye_m": [1e300, 2, 3], "target_m": [0, 0, 0]})");
    refused("stack --camera camera.json",
            "camera.json: eye_m [1e+300,2,3]: must be three numbers from -1e9 to 1e9");
    for (const char* const body : {R"("radius_m": 1, "position_m": [0, 1e60, 0])", R"("radius_m": 1e-30)"}) {
        folder.write("far.json", std::string(R"({"version": 1, "bodies": [{"name": "ball", "shape": "sphere",
            "mass_kg": 1, )") + body +
                                     "}]}");
        const char* const words = "far: body ball: must be within 1e12 m of the origin, and of 1e-12 to 1e12 m";
        refused("far.json --at 0", words);
        refused("far.json --frames off --replay far.html", words);
        check_refused(folder, "pushfactor run far.json --glb far.glb", words);
        CHECK(shell(folder, "pushfactor run far.json --seconds 0.1").status == 0);
    }
    CHECK(!std::filesystem::exists(folder / "frames/config.json"));
}

TEST_CASE("what is refused leaves no folder, and a folder that gets another scene is named") {
    const Folder folder;
    for (const char* const render : {"chain --overlay contacts", "stack --scheme rattle4"}) {
        check_refused(folder, std::string("pushfactor render --at 0 ") + render, "s");
        CHECK(!std::filesystem::exists(folder / "out"));
    }
    const auto said = [&](const std::string& scene) {
        return shell(folder, "pushfactor render --at 0 --size 64x64 " + scene).err;
    };
    CHECK(said("stack").empty());
    CHECK(shell(folder, "pushfactor scene stack --count 2 > stack.json").status == 0);
    CHECK(said("stack.json") ==
          "pushfactor: note: out/stack had the pictures of scene stack, and gets those of stack.json\n");
    CHECK(said("stack.json").empty());
}

TEST_CASE("outputs and scenes never have the names of the files that render writes") {
    const Folder folder;
    require_success(folder,
                    "pushfactor scene stack > config.json && pushfactor render stack --at 0 --size 64x64 --out r");
    const auto before = folder.read("r/config.json");
    const auto refused = [&](const std::string& arguments, const std::string& words) {
        check_refused(folder, "pushfactor render --at 0 --size 64x64 " + arguments,
                      words + ": must have another name");
    };
    refused("stack --out r --csv r/config.json", "r/config.json");
    refused("stack --out r --summary ./r/../r/config.json", "./r/../r/config.json");
    refused("stack --out r --rows r/summary.json", "r/summary.json");
    refused("stack --out r --csv r/at_0s.png", "r/at_0s.png");
    refused("config.json --out .", "config.json");
    CHECK(folder.read("r/config.json") == before);
    require_success(folder, "pushfactor render stack --at 0 --size 64x64 --out r --summary r/summary.json");
    // A file that spells out all options may be compared in one of them.
    require_success(folder, "pushfactor render --config r/config.json --compare push=none,persistent --out s");
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

TEST_CASE("without ffmpeg nothing is rendered in vain, and the message says what to install") {
    const Folder folder;
    const Ended ended = shell(folder,
                              "PATH=/nowhere pushfactor render stack --seconds 0.1 --fps 10 --size 64x36 "
                              "--out frames --video film.mp4 --frames off");
    CHECK(ended.status == 4);
    CHECK(ended.err == "pushfactor: --video film.mp4: ffmpeg is not installed; on Debian: apt install ffmpeg\n");
    CHECK(folder.files().empty());
}

TEST_CASE("an ffmpeg that fails ends the run with its own words and leaves no video") {
    const Folder folder;
    require_success(folder, "pushfactor render stack --at 0 --size 64x36 --out frames");
    REQUIRE(std::filesystem::exists(folder / "frames/summary.json"));
    fake_ffmpeg(folder, "echo 'Unknown encoder' >&2; exit 1");
    const Ended ended = shell(folder,
                              "PATH=.:$PATH pushfactor render stack --seconds 1 --size 64x36 --out frames "
                              "--video film.mp4");
    CHECK(ended.status == 4);
    CHECK(ended.err.find("film.mp4: ffmpeg ended with status 1: Unknown encoder") != std::string::npos);
    CHECK(!std::filesystem::exists(folder / "film.mp4"));
    // The summary of an earlier run would be taken for that of the one that failed.
    CHECK(!std::filesystem::exists(folder / "frames/summary.json"));
}

TEST_CASE("a body is in front of its ghosts where they are nearly at one place") {
    // More bodies than the layers of body.vert.
    const std::string tower = "stack --count 20 --gap 0.01 --at 2 --rest off ";
    const Folder alone, with_ghosts;
    REQUIRE(render(alone, tower + "--ghosts 2").status == 0);  // none, and as much room for the legend
    REQUIRE(render(with_ghosts, tower + "--ghosts 0.5,1,1.5").status == 0);
    const auto above_legend = [](const Folder& folder) {
        pushfactor::renderer::Image image = image_in(folder, "frames/at_2s.png");
        image.height -= 40;
        image.rgb.resize(3 * static_cast<std::size_t>(image.width * image.height));
        return image;
    };
    CHECK(pushfactor::renderer::ImageDifference(above_legend(alone), above_legend(with_ghosts)).share_above(30) <
          0.02);
}

TEST_CASE("every frame of a film is the still of its time, drawn by itself") {
    // Bodies that fall and come to rest, a camera that turns, walls, bars, several samples per picture, two panels.
    for (const std::string scene :
         {"stack --count 2 --gap 0.05 --seconds 1 --fps 20 --camera scene",
          "stack --seconds 0.5 --fps 20 --camera orbit:40",
          "funnel --solver pgs --count 5 --seconds 1.5 --fps 10 --camera scene",
          "pendulum-grid --seconds 0.3 --fps 30 --camera scene",
          "pendulum-wave --seconds 0.2 --fps 30 --samples 2 --camera scene",
          "intersecting-stack --seconds 0.6 --fps 10 --camera scene --compare push=none,persistent",
          "stack --seconds 0.5 --fps 20 --camera scene --samples 16 --shutter 0.5 --ghosts 0 --overlay trails"}) {
        const Folder folder;
        INFO(scene);
        REQUIRE(render(folder, scene).status == 0);
        for (const auto& [frame, at] : {std::pair{"frame_000003.png", 3}, std::pair{"frame_000005.png", 5}}) {
            const bool thirty = scene.find("--fps 30") != std::string::npos;
            const bool twenty = scene.find("--fps 20") != std::string::npos;
            const std::string time = std::to_string(at) + "/" + (thirty ? "30" : twenty ? "20" : "10");
            const Folder alone;
            // A still has no frame rate, unless its shutter is open for a share of a frame.
            std::string options = scene;
            const std::size_t rate = options.find(" --fps ");
            if (scene.find("--shutter") == std::string::npos) options.erase(rate, std::string(" --fps 20").size());
            const Ended still = render(alone, options + " --at " + time);
            INFO(still.err);
            REQUIRE(still.status == 0);
            for (const std::string& name : alone.files()) {
                if (name.ends_with(".png"))
                    CHECK(image_in(alone, name) == image_in(folder, std::string("frames/") + frame));
            }
        }
    }
}

TEST_CASE("both kinds of OpenGL give the same files, and the config file remembers which it was") {
    const Folder folder;
    const std::string options = "stack --seconds 0.5 --at 0.5 --size 160x90 ";
    REQUIRE(shell(folder, "pushfactor render " + options + "--gl osmesa --out osmesa").status == 0);
    const Ended egl = shell(folder, "pushfactor render " + options + "--gl egl --out egl");
    if (egl.err.find("cannot load EGL") != std::string::npos) {
        WARN("EGL is not installed, so it is not tested: " << egl.err);
        return;
    }
    INFO(egl.err);
    REQUIRE(egl.status == 0);
    CHECK(folder.read("egl/at_0.5s.png") == folder.read("osmesa/at_0.5s.png"));
    CHECK(folder.read("egl/config.json").find("\"gl\": \"egl\"") != std::string::npos);
    REQUIRE(shell(folder, "pushfactor render --config egl/config.json --out again").status == 0);
    CHECK(folder.read("again/config.json") == folder.read("egl/config.json"));
    CHECK(folder.read("again/at_0.5s.png") == folder.read("egl/at_0.5s.png"));
    check_refused("render stack --at 0 --gl vulkan", "--gl vulkan: must be osmesa or egl");
}

TEST_CASE("with --timing render says how long each stage took, and changes no frame") {
    const Folder folder;
    const Ended timed = render(folder, "stack --seconds 0.2 --fps 10 --timing");
    REQUIRE(timed.status == 0);
    for (const char* stage : {"simulate", "shadow map", "ground", "bodies", "read back", "smooth edges", "encode",
                              "write", "3 frames: ", "the floor"}) {
        INFO(stage);
        CHECK(timed.err.find(stage) != std::string::npos);
    }
    const Folder plain;
    CHECK(render(plain, "stack --seconds 0.2 --fps 10").err.empty());
    CHECK(plain.read("frames/frame_000002.png") == folder.read("frames/frame_000002.png"));
}

TEST_CASE("a frame that cannot be written ends the film: one message, and all frames before it are whole") {
    const Folder folder;
    std::filesystem::create_directories(folder / "frames/frame_000005.png");
    const Ended ended = render(folder, "stack --seconds 2 --fps 20");
    CHECK(ended.status == 4);
    CHECK(ended.err == "pushfactor: --out frames: frames/frame_000005.png: Is a directory\n");
    CHECK(folder.files() == std::vector<std::string>{"frames/config.json", "frames/frame_000000.png",
                                                     "frames/frame_000001.png", "frames/frame_000002.png",
                                                     "frames/frame_000003.png", "frames/frame_000004.png"});
    for (int i = 0; i < 5; ++i) {
        const std::string bytes = folder.read("frames/frame_00000" + std::to_string(i) + ".png");
        CHECK(bytes.substr(bytes.size() - 8, 4) == "IEND");
    }
}
