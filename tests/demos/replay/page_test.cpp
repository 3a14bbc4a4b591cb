// Replays in a browser: what it draws, says and asks for, and how it is driven. Skipped with a warning where there
// is no Chromium.
#include "renderer/images/read_png.h"
#include "tests/catch.h"
#include "tests/demos/browser.h"
#include "tests/demos/csv.h"
#include "tests/renderer/image_difference.h"
#include "tests/skip.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <memory>

using namespace pushfactor::tests;
using pushfactor::demos::Json;
using pushfactor::demos::parse_json;
using pushfactor::renderer::Image;

namespace {

constexpr int width = 320, height = 180;  // pixels

std::string address_of(const Folder& folder, const std::string& file, const std::string& hash = "") {
    return "file://" + (folder / file).string() + (hash.empty() ? "" : "#" + hash);
}

Image image_in(const Folder& folder, const std::string& name) {
    const std::string bytes = folder.read(name);
    return pushfactor::renderer::decode_png(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
}

// Two thirds of the columns.
Image left_part(const Image& image) {
    Image part{.width = 2 * image.width / 3, .height = image.height, .rgb = {}};
    for (int y = 0; y < image.height; ++y) {
        const auto row = image.rgb.begin() + 3L * y * image.width;
        part.rgb.insert(part.rgb.end(), row, row + 3L * part.width);
    }
    return part;
}

// The poses of a frame in the page against those in the trajectory, relative to what the README promises.
void check_poses(const Json& shown, const Json& units, const std::vector<std::vector<std::string>>& table,
                 std::size_t first_line, std::size_t bodies) {
    for (std::size_t line = first_line; line < first_line + bodies; ++line) {
        const auto number = [&](std::size_t column) { return std::stod(table[line][column]); };
        const auto body = static_cast<std::size_t>(number(1));
        double apart = 0.0, along = 0.0, length = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            apart = std::hypot(apart, shown["positions"][3 * body + k].get<double>() - number(2 + k));
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const double part = shown["orientations"][4 * body + k].get<double>();
            along += part * number(5 + k);
            length = std::hypot(length, part);
        }
        INFO("body " << body);
        CHECK(apart <= 1e-4 * units[body].get<double>() + 1e-12);
        CHECK(length == Approx(1.0).margin(1e-12));
        // 1 - cos(half the angle) of 1e-4 rad is 1.25e-9.
        CHECK(std::abs(along) >= 1.0 - 1.26e-9);
    }
}

}  // namespace

TEST_CASE(
    "the replay of each scene opens from disk in silence, shows the picture of the instant, and each frame's "
    "poses") {
    const auto browser = open_browser();
    if (!browser) return;
    const bool same_driver = gl_of(*browser).find("llvmpipe") != std::string::npos;
    if (!same_driver) WARN("drawn by " + gl_of(*browser) + ": pictures are compared loosely");
    const Folder folder;
    const std::vector<std::string> scenes{"stack",
                                          "intersecting-stack",
                                          "funnel",
                                          "pendulum-grid",
                                          "pendulum-wave",
                                          "chain",
                                          "heavy-on-light",
                                          "arch",
                                          "dominoes",
                                          "platonic",
                                          PUSHFACTOR_SOURCE_DIR "/assets/scenes/rover.json"};
    for (const std::string& scene : scenes) {
        INFO(scene);
        const Ended ended =
            shell(folder, fmt::format("pushfactor render {} --seconds 0.5 --size {}x{} --caption off --out frames "
                                      "--replay run.html --trajectory run.csv",
                                      scene, width, height));
        INFO(ended.err);
        REQUIRE(ended.status == 0);
        browser->open(address_of(folder, "run.html", "bare"), width, height);
        browser->value_of("pushfactor.ready");
        REQUIRE(browser->value_of("pushfactor.frames") == 31);

        const auto table = table_of(folder.read("run.csv"));
        const std::size_t bodies = (table.size() - 1) / 31;
        const Json units = browser->value_of("pushfactor.units()");
        for (const std::size_t frame : {30u, 0u, 17u, 16u}) {
            INFO("frame " << frame);
            browser->value_of(fmt::format("pushfactor.seek({})", frame));
            CHECK(browser->value_of("pushfactor.frame") == frame);
            check_poses(browser->value_of("pushfactor.poses()"), units, table, 1 + frame * bodies, bodies);
        }
        // Frame 16 is shown now.
        const auto difference = pushfactor::renderer::ImageDifference(image_in(folder, "frames/frame_000016.png"),
                                                                      browser->screenshot());
        INFO("similarity " << difference.similarity() << " dB, seen " << difference.share_above(2) << ", large "
                           << difference.share_above(16));
        CHECK((same_driver ? pushfactor::renderer::same_to_the_eye(difference) : difference.similarity() > 38.0));
        check_quiet(*browser);
    }
}

TEST_CASE("arrows of a replay are those of the picture") {
    const auto browser = open_browser();
    if (!browser) return;
    const Folder folder;
    REQUIRE(
        shell(folder, fmt::format("pushfactor render stack --seconds 0.6 --size 640x360 --caption off --out frames "
                                  "--overlay contacts,forces,velocities --replay run.html"))
            .status == 0);
    browser->open(address_of(folder, "run.html", "t=0.5&bare"), 640, 360);
    browser->value_of("pushfactor.ready");
    const Image shown = browser->screenshot();
    browser->value_of("pushfactor.show([])");
    const Image without = browser->screenshot();
    // The legend is in the picture's lower right corner, and not here; arrows are smoothed by the browser.
    const Image picture = left_part(image_in(folder, "frames/frame_000030.png"));
    const auto difference = pushfactor::renderer::ImageDifference(picture, left_part(shown));
    INFO("similarity " << difference.similarity() << " dB, large " << difference.share_above(16));
    CHECK(difference.similarity() > 36.0);                                                          // 40.6
    CHECK(pushfactor::renderer::ImageDifference(picture, left_part(without)).similarity() < 33.0);  // 30.6
}

TEST_CASE("a replay is driven by keys, pointer and address") {
    const auto browser = open_browser();
    if (!browser) return;
    const Folder folder;
    REQUIRE(shell(folder,
                  "pushfactor render intersecting-stack --seconds 1 --compare push=persistent,single-frame "
                  "--camera scene --frames off --replay run.html")
                .status == 0);
    CHECK(folder.files() == std::vector<std::string>{"out/intersecting-stack/config.json",
                                                     "out/intersecting-stack/summary.json", "run.html"});
    // Whether an expression becomes true; waits for it as long as it takes.
    const auto becomes = [&](const std::string& expression) {
        return browser->value_of(
            fmt::format("(async () => {{ for (let i = 0; i < 1000; ++i) {{ if ({}) return true;"
                        "await new Promise((done) => setTimeout(done, 10)); }} return false; }})()",
                        expression));
    };
    const auto leads_to = [&](const std::string& key, int frame) {
        browser->press(key);
        return becomes(fmt::format("pushfactor.frame === {}", frame));
    };
    const auto text_of = [&](const char* id) {
        return browser->value_of(fmt::format("document.getElementById('{}').textContent", id)).get<std::string>();
    };
    browser->open(address_of(folder, "run.html", "t=0.5"), 1280, 900);
    browser->value_of("pushfactor.ready");
    CHECK(browser->value_of("pushfactor.frame") == 30);
    CHECK(browser->value_of("pushfactor.runs") == Json{"push persistent", "push single-frame"});
    CHECK(leads_to("ArrowRight", 31));
    CHECK(leads_to("ArrowLeft", 30));
    CHECK(leads_to("End", 60));
    CHECK(leads_to("ArrowRight", 60));
    CHECK(leads_to("Home", 0));
    browser->press(" ");
    CHECK(becomes("pushfactor.frame > 0"));  // plays
    browser->value_of("pushfactor.pause()");
    CHECK(text_of("time").find("frame ") != std::string::npos);

    // The state hash is the summary's.
    const Json summary = parse_json(folder.read("out/intersecting-stack/summary.json"));
    for (const std::size_t run : {0u, 1u}) {
        CHECK(browser->value_of("pushfactor.stateHashes")[run] == summary["panels"][run]["state_hash"]);
    }
    CHECK(text_of("command") ==
          "pushfactor render intersecting-stack --seconds 1 --compare "
          "push=persistent,single-frame --camera scene --frames off --replay run.html");

    // A click on the lowest cube of the right half, seen by its place in the picture.
    browser->value_of("pushfactor.seek(60)");
    const Json place = browser->value_of("pushfactor.onPage(pushfactor.pose(1, 1).position, 1)");
    browser->click(place[0], place[1]);
    CHECK(browser->value_of("document.getElementById('which').value") == "1:1");
    const Json facts = browser->value_of("pushfactor.facts(1, 1)");
    CHECK(facts["name"] == browser->value_of("pushfactor.bodies(1)[1]"));
    CHECK(becomes("document.getElementById('facts').textContent.includes('Kinetic energy')"));
    // It carries four others: the ground pushes with five weights, and what is on it presses with four.
    CHECK(facts["sum"][1].get<double>() == Approx(10.0 * facts["mass"].get<double>()).epsilon(0.02));

    // The address tells the instant and the camera: opened anew it shows the same picture.
    browser->press("3");
    browser->press("a");
    browser->press("g");
    CHECK(becomes("location.hash.includes('mode=ghost')"));
    const std::string hash = browser->value_of("location.hash");
    // Observers of sizes are called between the frames of the page; then it is drawn to the end.
    const char* const settled =
        "(async () => { const frame = () => new Promise((done) => requestAnimationFrame(done));"
        "for (let i = 0; i < 3; ++i) await frame(); pushfactor.timeDrawing(1); await frame(); })()";
    browser->value_of("document.body.classList.add('bare')");
    browser->value_of(settled);
    const Json camera = browser->value_of("pushfactor.camera()");
    const Image before = browser->screenshot();
    check_quiet(*browser);
    browser->open(address_of(folder, "run.html", hash.substr(1) + "&bare"), 1280, 900);
    browser->value_of("pushfactor.ready");
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(browser->value_of("pushfactor.camera()")["eye"][k].get<double>() ==
              Approx(camera["eye"][k].get<double>()).epsilon(1e-5));
    }
    browser->value_of(settled);
    const auto difference = pushfactor::renderer::ImageDifference(before, browser->screenshot());
    INFO("similarity " << difference.similarity());
    CHECK(difference.similarity() > 40.0);
    check_quiet(*browser);
}

TEST_CASE("a frame of a replay is as long as that of the run, whatever the steps and the speed of the film") {
    const auto browser = open_browser();
    if (!browser) return;
    const Folder folder;
    const auto seconds_a_frame = [&](const std::string& arguments) {
        const Ended ended = shell(folder, "pushfactor " + arguments + " --replay run.html");
        INFO(ended.err);
        REQUIRE(ended.status == 0);
        browser->open(address_of(folder, "run.html"), 400, 300);
        browser->value_of("pushfactor.ready");
        return browser->value_of("pushfactor.secondsAFrame").get<double>();
    };
    CHECK(seconds_a_frame("run stack --seconds 0.2 --dt 1/240") == Approx(1.0 / 60.0));
    CHECK(seconds_a_frame("run stack --seconds 0.2 --dt 1/50") == Approx(1.0 / 50.0));
    CHECK(seconds_a_frame("run stack --seconds 0.2 --fps 20") == Approx(1.0 / 20.0));
    CHECK(seconds_a_frame("render stack --seconds 0.2 --dt 1/240 --play-speed 1/4 --frames off") ==
          Approx(1.0 / 240.0));
    CHECK(seconds_a_frame("render stack --seconds 0.2 --dt 1/240 --fps 30 --frames off") == Approx(1.0 / 30.0));
}

TEST_CASE("without WebGL 2 a replay says so and still has numbers and plots") {
    if (!find_browser()) {
        skip("no Chromium is installed");
        return;
    }
    const Folder folder;
    REQUIRE(shell(folder, "pushfactor run stack --seconds 0.5 --replay run.html").status == 0);
    Browser browser({"--disable-3d-apis"});
    browser.open(address_of(folder, "run.html"), 800, 600);
    browser.value_of("pushfactor.ready");
    CHECK(browser.value_of("document.getElementById('problem').textContent").get<std::string>().find("WebGL 2") !=
          std::string::npos);
    browser.value_of("pushfactor.seek(7)");
    CHECK(browser.value_of("document.getElementById('time').textContent").get<std::string>().find("frame 7") !=
          std::string::npos);
    CHECK(browser.requests() == std::vector<std::string>{});
}
