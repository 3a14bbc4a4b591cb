// `pushfactor doctor`: what it finds, and its exit status where nothing can be drawn.
#include "demos/base/platform/processors.h"
#include "demos/base/text/json.h"
#include "demos/pictures/offscreen_renderer.h"
#include "renderer/images/read_png.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

#include <fmt/format.h>

using namespace pushfactor::demos;
using namespace pushfactor::tests;

namespace {

// Library files that cannot be loaded, to be found before those of the system.
void hide(const Folder& folder, const std::vector<std::string>& libraries) {
    for (const std::string& library : libraries) folder.write(library, "");
}
const std::vector<std::string> osmesa{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
const std::vector<std::string> egl{"libEGL.so.1", "libEGL.so"};

std::string line_of(const std::string& text, const std::string& name) {
    for (const std::string& line : lines_of(text)) {
        if (line.starts_with(name + " ")) return line;
    }
    return "";
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("doctor draws a picture here, and prints the hash of the file that it writes") {
    const Folder folder;
    const Ended ended = shell(folder, "pushfactor doctor --out test.png");
    INFO(ended.out << ended.err);
    REQUIRE(ended.status == 0);
    CHECK(ended.err == "");
    const std::string png = folder.read("test.png");
    const auto image = pushfactor::renderer::decode_png(std::vector<std::uint8_t>(png.begin(), png.end()));
    const std::string picture = line_of(ended.out, "picture");
    CHECK(has(picture, fmt::format("OK: 320x180, hash {:016x}", pictures::hash_of(image))));
    CHECK(has(picture, "test.png"));
    for (const char* name : {"pushfactor", "OSMesa", "EGL", "font", "assets", "ffmpeg", "gnuplot", "cores"}) {
        INFO(name);
        CHECK(line_of(ended.out, name).size() > 12);
    }
}

TEST_CASE("doctor names what to install where nothing is installed, and ends with status 3") {
    const Folder folder;
    hide(folder, osmesa);
    hide(folder, egl);
    const std::string without = "export LD_LIBRARY_PATH=. PATH=/nonexistent; ";
    const Ended ended = shell(folder, without + "pushfactor doctor --out test.png");
    INFO(ended.out << ended.err);
    CHECK(ended.status == 3);
    CHECK(lines_of(ended.err).size() == 1);
    CHECK(has(line_of(ended.out, "OSMesa"), "install the package libosmesa6"));
    CHECK(has(line_of(ended.out, "EGL"), "install the packages libegl1, libegl-mesa0 and libgl1-mesa-dri"));
    CHECK(has(line_of(ended.out, "ffmpeg"), "not found: needed for --video; on Debian: apt install ffmpeg"));
    CHECK(has(line_of(ended.out, "gnuplot"), "apt install gnuplot-nox"));
    CHECK(has(line_of(ended.out, "picture"), "cannot be drawn"));
    CHECK(!std::filesystem::exists(folder / "test.png"));

    const Ended json = shell(folder, without + "pushfactor doctor --json");
    CHECK(json.status == 3);
    CHECK(parse_json(json.out).at("picture").at("ok") == false);
    CHECK(parse_json(json.out).at("font").at("ok") == true);

    // What draws says the same.
    const Ended render = shell(folder, without + "pushfactor render stack --at 0");
    CHECK(render.status == 1);
    CHECK(has(render.err, "libosmesa6"));
    CHECK(has(render.err, "libgl1-mesa-dri"));
}

TEST_CASE("one back end is enough") {
    for (const bool without_osmesa : {true, false}) {
        const Folder folder;
        hide(folder, without_osmesa ? osmesa : egl);
        const Ended ended = shell(folder, "export LD_LIBRARY_PATH=.; pushfactor doctor");
        INFO(ended.out << ended.err);
        if (has(line_of(ended.out, without_osmesa ? "EGL" : "OSMesa"), "cannot load")) continue;  // not installed
        CHECK(ended.status == 0);
        CHECK(has(line_of(ended.out, "picture"), without_osmesa ? "by EGL alone" : "by OSMesa alone"));
    }
}

TEST_CASE("doctor refuses other names than .png, and fails with status 4 where it cannot write") {
    check_refused("doctor --out test.jpg", "--out test.jpg: must end in .png");
    CHECK(run_program("doctor --out /proc/no/test.png").status == 4);
}

TEST_CASE("the limit of processor time is the smallest of the control group and those above it") {
    const Folder folder;
    std::filesystem::create_directories(folder / "a/b");
    const auto limit = [&](const std::string& own) {
        folder.write("own", own);
        return processor_limit(folder.path(), folder / "own");
    };
    CHECK(limit("0::/a/b\n") == std::nullopt);
    folder.write("a/b/cpu.max", "max 100000\n");
    CHECK(limit("0::/a/b\n") == std::nullopt);
    folder.write("cpu.max", "300000 100000\n");
    folder.write("a/cpu.max", "150000 100000\n");
    CHECK(limit("1:cpu:/x\n0::/a/b\n") == 1.5);
    folder.write("a/b/cpu.max", "50000 100000\n");
    CHECK(limit("0::/a/b\n") == 0.5);
    CHECK(limit("0::/\n") == 3.0);
    CHECK(limit("0::/../other\n") == 3.0);
    CHECK(limit("1:cpu:/x\n") == std::nullopt);
    CHECK(usable_cores() >= 1);
}
