// The page that runs the program in a browser. Skipped, with the reason, where there is no Chromium or no such
// page.
#include "demos/base/platform/assets.h"
#include "demos/options/named_run.h"
#include "tests/catch.h"
#include "tests/demos/browser.h"
#include "tests/renderer/image_difference.h"
#include "tests/skip.h"

#include <fmt/format.h>

using namespace pushfactor::tests;
using pushfactor::demos::command_text;
using pushfactor::demos::Json;
using pushfactor::demos::json_text;
using pushfactor::demos::OptionTexts;
using pushfactor::demos::parse_json;

namespace {

// 1.5 MB are the limit; Chromium needs WebAssembly with vectors, which it has since version 91.
constexpr std::uintmax_t most_bytes = 1500000;

bool is_there() {
    if (std::filesystem::exists(pushfactor::demos::live_page())) return true;
    skip("the page is not made (demos/run live)");
    return false;
}

std::string address(const std::string& hash = "") {
    return "file://" + pushfactor::demos::live_page().string() + (hash.empty() ? "" : "#" + hash);
}

// Opens the page and waits until it has drawn.
void open(Browser& browser, const std::string& hash, int width = 1280, int height = 900) {
    browser.open(address(hash), width, height);
    browser.value_of("pushfactor.ready");
}

// Whether an expression becomes true; waits for it as long as it takes.
bool becomes(Browser& browser, const std::string& expression) {
    return browser
        .value_of(fmt::format("(async () => {{ for (let i = 0; i < 2000; ++i) {{ if ({}) return true;"
                              "await new Promise((done) => setTimeout(done, 10)); }} return false; }})()",
                              expression))
        .get<bool>();
}

std::string text_of(Browser& browser, const std::string& selector) {
    return browser.value_of(fmt::format("document.querySelector('{}').textContent", selector)).get<std::string>();
}

// The hash after 600 steps in the committed list.
std::string listed(const std::string& scene, const OptionTexts& options) {
    for (const std::string& line : lines_of(read_file(PUSHFACTOR_SOURCE_DIR "/tests/hashes/lines.txt"))) {
        if (line.ends_with("  " + command_text("run", scene, options))) return line.substr(17, 16);
    }
    return "not in the list";
}

}  // namespace

TEST_CASE("the page in a browser makes all five scenes with the bits of the list") {
    const auto browser = is_there() ? open_browser() : nullptr;
    if (!browser) return;
    CHECK(std::filesystem::file_size(pushfactor::demos::live_page()) <= most_bytes);
    open(*browser, "scenes&scene=stack", 640, 480);
    for (const char* const scene : {"stack", "intersecting-stack", "funnel", "pendulum-grid", "pendulum-wave"}) {
        for (const char* const preset : {"paper", "default", "exact"}) {
            INFO(scene << " " << preset);
            browser->value_of(
                fmt::format("pushfactor.open('{}', [['preset', '{}'], ['rest', 'off']])", scene, preset));
            browser->value_of("pushfactor.advance(600)");
            CHECK(browser->value_of("pushfactor.steps[0]") == 600);
            CHECK(browser->value_of("pushfactor.stateHashes[0]") ==
                  listed(scene, {{"preset", preset}, {"dt", "1/60"}, {"seconds", "10"}}));
        }
    }
    check_quiet(*browser);
}

TEST_CASE(
    "Figure 7 in a browser: the persistent push throws the cubes, the single-frame push does not, and says so") {
    const auto browser = is_there() ? open_browser() : nullptr;
    if (!browser) return;
    open(*browser, "figure&step=30");
    CHECK(browser->value_of("pushfactor.steps") == Json{30, 30, 30});
    const auto card = [&](int number) { return text_of(*browser, fmt::format("#cards > :nth-child({})", number)); };
    CHECK(card(1).find("What overlaps is not parted") != std::string::npos);
    CHECK(card(2).find("keep the speed of the push: they fly") != std::string::npos);
    CHECK(card(3).find("They are apart, and at rest") != std::string::npos);
    // Each command makes the run that is shown.
    const Folder folder;
    for (const std::size_t i : {0u, 1u, 2u}) {
        const std::string command = browser->value_of("pushfactor.commands")[i];
        INFO(command);
        REQUIRE(shell(folder, command + " --summary run.json").status == 0);
        CHECK(parse_json(folder.read("run.json"))["state_hash"] == browser->value_of("pushfactor.stateHashes")[i]);
    }
    // Another beta starts it anew, by itself, up to the instant of the figure.
    browser->value_of(
        "(() => { const beta = document.querySelector('[data-slider=beta]'); beta.value = '0.6';"
        "beta.dispatchEvent(new Event('input')); })()");
    CHECK(becomes(*browser, "!pushfactor.playing && pushfactor.steps[2] === 30"));
    CHECK(browser->value_of("pushfactor.commands")[1] ==
          "pushfactor run intersecting-stack --preset paper --beta 0.6 --seconds 0.5");
    CHECK(becomes(*browser, "location.hash === '#figure&beta=0.6&step=30'"));
    check_quiet(*browser);
}

TEST_CASE("an address opens the same state and the same picture again") {
    const auto browser = is_there() ? open_browser() : nullptr;
    if (!browser) return;
    open(*browser, "scenes&scene=intersecting-stack&preset=default&count=3&step=40&show=forces", 800, 900);
    browser->press("a");
    browser->press("e");
    CHECK(becomes(*browser, "location.hash.includes('eye=')"));
    const Json hashes = browser->value_of("pushfactor.stateHashes");
    const std::string hash = browser->value_of("location.hash");
    const auto before = browser->screenshot();
    open(*browser, "figure", 800, 900);
    open(*browser, hash.substr(1), 800, 900);
    CHECK(browser->value_of("pushfactor.stateHashes") == hashes);
    CHECK(browser->value_of("pushfactor.steps[0]") == 40);
    const auto difference = pushfactor::renderer::ImageDifference(before, browser->screenshot());
    INFO("similarity " << difference.similarity());
    CHECK(difference.similarity() > 40.0);
    check_quiet(*browser);
}

TEST_CASE("the microscope in a browser takes a row per key, and ends with the forces of the step") {
    const auto browser = is_there() ? open_browser() : nullptr;
    if (!browser) return;
    open(*browser, "rows");
    const Json seen = browser->value_of("pushfactor.rows");
    const auto rows = seen["rows"].size();
    REQUIRE(rows == 8);
    const auto shown = [&](std::size_t row, int column) {
        return text_of(*browser, fmt::format("#rows tbody tr:nth-child({}) td:nth-child({})", row + 1, column));
    };
    CHECK(shown(0, 4) == "0");
    browser->press("ArrowRight");
    CHECK(shown(0, 4) == browser->value_of(fmt::format("String(Number(({}).toPrecision(4)))",
                                                       seen["lambda"][0][1][0].get<double>())));
    CHECK(shown(1, 4) == "0");
    CHECK(text_of(*browser, "#time") == "sweep 1 of 25, 1 of 200 rows");
    browser->press("End");
    CHECK(
        text_of(*browser, "#outcome").find("cube 2 is moved with 19.2 m/s upwards in this step, and keeps 0 m/s") !=
        std::string::npos);
    for (std::size_t row = 0; row < rows; ++row) {
        CHECK(shown(row, 4) == browser->value_of(fmt::format("String(Number(({}).toPrecision(4)))",
                                                             seen["lambda"][0].back()[row].get<double>())));
    }
    check_quiet(*browser);
}

TEST_CASE("the page in a browser refuses in one line, and keeps what it shows") {
    const auto browser = is_there() ? open_browser() : nullptr;
    if (!browser) return;
    open(*browser, "scenes&scene=stack&preset=paper&step=10");
    const Json hashes = browser->value_of("pushfactor.stateHashes");
    browser->value_of("pushfactor.open('stack', [['preset', 'paper'], ['beta', '2']])");
    CHECK(text_of(*browser, "#problem") == "--beta 2: must be a number from 0 to 1");
    CHECK(browser->value_of("pushfactor.stateHashes") == hashes);
    // A file that is dropped on the page, first a wrong one.
    const auto drop = [&](const std::string& name, const std::string& text) {
        browser->value_of(
            fmt::format("(async () => {{ const data = new DataTransfer();"
                        "data.items.add(new File([{}], '{}'));"
                        "document.dispatchEvent(new DragEvent('drop', {{dataTransfer: data, bubbles: true, "
                        "cancelable: true}})); }})()",
                        json_text(text, -1), name));
    };
    drop("mine.json", R"({"version": 1, "bodies": [{"name": "ball", "shape": "ball"}]})");
    CHECK(becomes(*browser, "document.getElementById('problem').textContent.startsWith('mine.json: ')"));
    CHECK(text_of(*browser, "#problem").find("shape") != std::string::npos);
    drop("belt.json", read_file(PUSHFACTOR_SOURCE_DIR "/assets/scenes/conveyor.json"));
    CHECK(becomes(*browser, "document.getElementById('problem').hidden"));
    browser->value_of("pushfactor.advance(30)");
    CHECK(browser->value_of("pushfactor.commands[0]") == "pushfactor run belt.json --seconds 0.5");
    // Its address has the file.
    CHECK(becomes(*browser, "location.hash.includes('file=')"));
    const Json state = browser->value_of("pushfactor.stateHashes");
    browser->press("a");
    CHECK(becomes(*browser, "location.hash.includes('step=30') && location.hash.includes('eye=')"));
    const std::string hash = browser->value_of("location.hash");
    open(*browser, "figure");
    open(*browser, hash.substr(1));
    CHECK(browser->value_of("pushfactor.stateHashes") == state);
    check_quiet(*browser);
}

TEST_CASE("without WebGL 2 the page in a browser says so, and still has numbers and plots") {
    if (!find_browser()) {
        skip("no Chromium is installed");
        return;
    }
    if (!is_there()) return;
    Browser browser({"--disable-3d-apis"});
    open(browser, "figure&step=30", 800, 600);
    CHECK(text_of(browser, "#problem").find("WebGL 2") != std::string::npos);
    CHECK(text_of(browser, "#cards").find("they fly") != std::string::npos);
    CHECK(browser.requests() == std::vector<std::string>{});
}
