// The command check: green for what is equal, red and named for each thing that may change, and nothing lost.
#include "tests/catch.h"
#include "tests/demos/browser.h"
#include "tests/demos/pages/check_page.h"
#include "tests/demos/program.h"
#include "tests/skip.h"

#include <iostream>
#include <map>

using namespace pushfactor::tests;

namespace {

namespace fs = std::filesystem;

const char* const small = "--seconds 0.4 --fps 10 --size 160x90";

// Folders of two scenes in `gold`.
void render_gold(const Folder& folder) {
    const Ended ended =
        shell(folder, std::string("pushfactor render stack intersecting-stack --out gold ") + small);
    INFO(ended.err);
    REQUIRE(ended.status == 0);
}

// All files of a folder, by name.
std::map<std::string, std::string> contents(const Folder& folder, const std::string& part) {
    std::map<std::string, std::string> files;
    for (const std::string& name : folder.files()) {
        if (name.starts_with(part + "/")) files[name] = folder.read(name);
    }
    return files;
}

void replace(const Folder& folder, const std::string& file, const std::string& from, const std::string& to) {
    std::string text = folder.read(file);
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    folder.write(file, text.replace(at, from.size(), to));
}

bool has_line(const std::string& text, const std::string& begin) {
    const auto lines = lines_of(text);
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.starts_with(begin); });
}

}  // namespace

TEST_CASE("check is green for every named scene, twice, and its page opens") {
    const Folder folder;
    const Ended rendered = shell(
        folder, "pushfactor render $(pushfactor list --names) --seconds 0.2 --fps 10 --size 96x54 --out gold");
    INFO(rendered.err);
    REQUIRE(rendered.status == 0);
    const auto before = contents(folder, "gold");
    for (const char* const options : {"", " --jobs 3"}) {
        const Ended ended = shell(folder, std::string("pushfactor check gold") + options);
        INFO(ended.out << ended.err);
        CHECK(ended.status == 0);
        CHECK(ended.out == "30 pictures and 10 runs are as expected; see out/check/index.html\n");
    }
    CHECK(contents(folder, "gold") == before);
    check_page(folder.read("out/check/index.html"));
    CHECK(folder.read("out/check/index.html").find("class=\"modes\"") == std::string::npos);
}

TEST_CASE("check names a missing, a truncated and an unexpected picture and one of another size") {
    const Folder folder;
    render_gold(folder);
    const std::string frame = "gold/stack/frame_00000";
    fs::remove(folder / (frame + "0.png"));
    folder.write(frame + "1.png", folder.read(frame + "1.png").substr(0, 2000));
    fs::copy_file(folder / (frame + "2.png"), folder / "gold/stack/other.png");
    REQUIRE(shell(folder, "pushfactor render stack --at 0 --size 64x36 --out other").status == 0);
    fs::copy_file(folder / "other/at_0s.png", folder / (frame + "3.png"), fs::copy_options::overwrite_existing);

    const Ended ended = shell(folder, "pushfactor check gold --junit verdicts.xml --markdown summary.md");
    CHECK(ended.status == 3);
    CHECK(ended.err == "pushfactor: 3 of 10 pictures differ; 1 picture unexpected; see out/check/index.html\n");
    INFO(ended.out);
    CHECK(lines_of(ended.out).size() == 4);
    CHECK(has_line(ended.out, frame + "0.png: missing"));
    CHECK(has_line(ended.out, frame + "1.png: not a whole PNG file"));
    CHECK(has_line(ended.out, frame + "3.png: another size: 160x90 instead of 64x36 pixels"));
    CHECK(has_line(ended.out, "gold/stack/other.png: unexpected"));
    check_page(folder.read("out/check/index.html"));

    const std::string junit = folder.read("verdicts.xml");
    CHECK(junit.find("<testsuite name=\"gold/stack\"") != std::string::npos);
    CHECK(junit.find("tests=\"8\" failures=\"3\" errors=\"0\" skipped=\"1\"") !=
          std::string::npos);  // five pictures and an unexpected one, options and physics
    CHECK(junit.find("message=\"missing\"") != std::string::npos);
    CHECK(folder.read("summary.md").find("| ❌ | gold/stack | 7 | 3 |") != std::string::npos);
}

TEST_CASE("check names a changed option, and the pictures that it changes") {
    const Folder folder;
    render_gold(folder);
    replace(folder, "gold/intersecting-stack/config.json", "\"beta\": 0.2", "\"beta\": 0.6");
    const Ended ended = shell(folder, "pushfactor check gold");
    INFO(ended.out);
    CHECK(ended.status == 3);
    CHECK(has_line(ended.out, "gold/intersecting-stack: options: beta 0.6 instead of 0.2"));
    CHECK(has_line(ended.out, "gold/intersecting-stack: physics: state hash "));
    CHECK(has_line(ended.out, "gold/intersecting-stack/frame_000004.png: "));
    CHECK_FALSE(has_line(ended.out, "gold/stack"));
    const std::string page = folder.read("out/check/index.html");
    CHECK(page.find("gold-intersecting-stack/frame_000004.png.difference.png") != std::string::npos);
    check_page(folder.read("out/check/index.html"));
}

TEST_CASE("the page of a check shows two pictures side by side, swapped, with a slider, and their difference") {
    const auto program = find_browser();
    if (!program) {
        skip("there is no browser (package chromium)");
        return;
    }
    const Folder folder;
    render_gold(folder);
    replace(folder, "gold/intersecting-stack/config.json", "\"beta\": 0.2", "\"beta\": 0.6");
    REQUIRE(shell(folder, "pushfactor check gold").status == 3);
    Browser browser({});
    browser.open("file://" + (folder / "out/check/index.html").string(), 900, 700);
    const auto shown = [&](const std::string& part) {
        return browser
            .value_of("(() => { const style = getComputedStyle(document.querySelector('.exhibit ." + part +
                      "')); return style.display !== 'none' && style.visibility !== 'hidden'; })()")
            .get<bool>();
    };
    const auto check_shown = [&](bool expected, bool actual, bool difference) {
        CHECK(shown("expected") == expected);
        CHECK(shown("actual") == actual);
        CHECK(shown("difference") == difference);
    };
    check_shown(true, true, true);
    browser.press("3");
    check_shown(true, true, false);
    browser.press("4");
    check_shown(false, false, true);
    browser.press("2");
    browser.value_of("document.querySelector('.stage').click()");  // from now on only clicks swap
    const bool first = shown("expected");
    CHECK(shown("actual") == !first);
    browser.value_of("document.querySelector('.stage').click()");
    check_shown(!first, first, false);
    CHECK(browser.messages().empty());
    for (const std::string& request : browser.requests()) CHECK(request.starts_with("file://"));
}

TEST_CASE("check sees a body that was moved by a millimetre, and says how far it is off") {
    const Folder folder;
    REQUIRE(shell(folder, "pushfactor scene stack > my.json").status == 0);
    replace(folder, "my.json", "\"name\": \"stack\"", "\"name\": \"my\"");
    REQUIRE(
        shell(folder, std::string("pushfactor render my.json --out gold --trajectory gold/trajectory.csv ") + small)
            .status == 0);
    CHECK(shell(folder, "pushfactor check gold").status == 0);
    CHECK(shell(folder, "pushfactor check gold --physics 1e-12").status == 0);

    replace(folder, "my.json", "0.0,\n        5.0,", "0.001,\n        5.0,");
    const Ended hash = shell(folder, "pushfactor check gold");
    CHECK(hash.status == 3);
    CHECK(has_line(hash.out, "gold: physics: state hash "));
    const Ended near = shell(folder, "pushfactor check gold --tolerance 255 --physics 1e-4");
    INFO(near.out << near.err);
    CHECK(near.status == 3);
    CHECK(has_line(near.out, "gold: physics: body 2 (cube 2) is 0.001 m off"));
    CHECK(shell(folder, "pushfactor check gold --tolerance 255 --physics 0.01").status == 0);
    const Ended off = shell(folder, "pushfactor check gold --tolerance 255 --physics off");
    CHECK(off.status == 0);
    CHECK(off.out == "5 pictures are as expected; see out/check/index.html\n");
}

TEST_CASE("a trajectory of which a part is missing does not say that the whole run is as expected") {
    const Folder folder;
    require_success(folder,
                    std::string("pushfactor render stack --out gold --trajectory gold/trajectory.csv ") + small);
    const auto cut = [&](const std::string& command, const std::string& words) {
        const Ended ended = shell(folder, "rm -rf now; cp -r gold now; " + command +
                                              " gold/trajectory.csv > now/trajectory.csv; pushfactor check now "
                                              "--physics 1e-6");
        INFO(ended.out << ended.err);
        CHECK(ended.status == 3);
        CHECK(ended.out.find("now: physics: " + words) != std::string::npos);
    };
    cut("head -11", "trajectory.csv ends at ");
    cut("head -9", "trajectory.csv has 8 lines instead of 10 for 5 moving bodies at 2 times");
    cut("sed '4,$ { /,3,/d }'", "trajectory.csv has ");
    cut("head -1", "not compared: trajectory.csv has no line of this run");
    CHECK(shell(folder, "pushfactor check gold --physics 1e-6").status == 0);
}

TEST_CASE("check counts a folder once however it is named, and never writes over what is expected") {
    const Folder folder;
    require_success(folder, std::string("pushfactor render stack --out gold ") + small);
    const auto before = contents(folder, "gold");
    const Ended twice = shell(folder, "pushfactor check gold/ gold ./gold");
    CHECK(twice.status == 0);
    CHECK(twice.out == "5 pictures and 1 run are as expected; see out/check/index.html\n");
    for (const char* const file :
         {"gold/config.json", "gold/summary.json", "./gold/frame_000000.png", "out/check/index.html"}) {
        for (const auto& [option, ending] : {std::pair{"--junit", ".xml"}, std::pair{"--markdown", ".md"}}) {
            check_refused(folder, fmt::format("pushfactor check gold {} {}", option, file),
                          fmt::format("{} {}: must end in {} within ", option, file, ending));
        }
    }
    check_refused(folder, "pushfactor report stability --quick --junit out/report-stability/index.html",
                  "must end in .xml within out/report-stability");
    require_success(folder, "pushfactor check gold --junit out/check/verdicts.xml");
    CHECK(contents(folder, "gold") == before);
}

TEST_CASE("check sees a light that was changed, with the tolerance and with FLIP") {
    const Folder folder;
    render_gold(folder);
    // An installed program, whose light is a little weaker.
    fs::create_directories(folder / "prefix/bin");
    fs::create_directories(folder / "prefix/share");
    fs::copy_file(PUSHFACTOR_PROGRAM, folder / "prefix/bin/pushfactor");
    fs::copy(PUSHFACTOR_ASSET_DIR, folder / "prefix/share/pushfactor", fs::copy_options::recursive);
    const std::string check = "prefix/bin/pushfactor check gold --physics off";
    CHECK(shell(folder, check).status == 0);
    replace(folder, "prefix/share/pushfactor/shaders/light.frag", "sun_light = 1.25", "sun_light = 1.15");
    for (const char* const how : {"", " --tolerance 2:1%", " --flip 0.001", " --gl egl"}) {
        const Ended ended = shell(folder, check + how);
        INFO(how << "\n" << ended.out << ended.err);
        CHECK(ended.status == 3);
        CHECK(has_line(ended.out, "gold/stack/frame_000000.png: "));
    }
    CHECK(shell(folder, check + " --tolerance 80").status == 0);
    CHECK(shell(folder, check + " --flip 0.2").status == 0);
}

TEST_CASE("check --update shows what it replaces, and then the folder is as expected") {
    const Folder folder;
    render_gold(folder);
    const auto before = contents(folder, "gold");
    replace(folder, "gold/intersecting-stack/config.json", "\"beta\": 0.2", "\"beta\": 0.6");
    fs::remove(folder / "gold/stack/frame_000002.png");

    const Ended ended = shell(folder, "pushfactor check gold --update");
    INFO(ended.out << ended.err);
    CHECK(ended.status == 0);
    CHECK(has_line(ended.out, "gold/intersecting-stack: options: beta 0.6 instead of 0.2"));
    CHECK(has_line(ended.out, "gold/stack/frame_000002.png: missing"));
    CHECK(has_line(ended.out, "gold/stack: 2 files updated"));
    CHECK(shell(folder, "pushfactor check gold").status == 0);

    const auto after = contents(folder, "gold");
    CHECK(after.size() == before.size());
    CHECK(after.at("gold/stack/frame_000002.png") == before.at("gold/stack/frame_000002.png"));
    CHECK(after.at("gold/intersecting-stack/frame_000004.png") !=
          before.at("gold/intersecting-stack/frame_000004.png"));
}

TEST_CASE("a check that is interrupted, or cannot write, leaves what was expected as it was") {
    const Folder folder;
    REQUIRE(shell(folder, "pushfactor render stack --seconds 10 --size 160x90 --out gold").status == 0);
    for (int i = 0; i < 9; ++i) fs::remove(folder / ("gold/frame_00000" + std::to_string(i) + ".png"));
    const auto before = contents(folder, "gold");

    const Ended stopped = stopped_when(folder, "test -e gold/.new/frame_000001.png", "check gold --update");
    CHECK(stopped.status == 1);
    CHECK(stopped.err == "pushfactor: interrupted: no expected file was changed\n");
    CHECK(contents(folder, "gold") == before);

    const Ended full = shell(folder, "ulimit -f 1; pushfactor check gold --update");
    CHECK(full.status == 4);
    CHECK(lines_of(full.err).size() == 1);
    CHECK(contents(folder, "gold") == before);

    folder.write("gold/.new", "in the way");
    const Ended shut = shell(folder, "pushfactor check gold --update");
    CHECK(shut.status == 4);
    CHECK(lines_of(shut.err).size() == 1);
    fs::remove(folder / "gold/.new");
    CHECK(contents(folder, "gold") == before);
}

TEST_CASE("check compares the panels of a comparison") {
    const Folder folder;
    REQUIRE(
        shell(folder, std::string("pushfactor render stack --compare push=none,single-frame --out gold ") + small)
            .status == 0);
    const Ended green = shell(folder, "pushfactor check gold");
    INFO(green.out << green.err);
    CHECK(green.status == 0);
    replace(folder, "gold/config.json", "none,single-frame", "none,persistent");
    const Ended red = shell(folder, "pushfactor check gold");
    CHECK(red.status == 3);
    CHECK(has_line(red.out, "gold: options of push persistent: push persistent instead of single-frame"));
}

TEST_CASE("check --against compares pictures that no run of ours made") {
    const Folder folder;
    render_gold(folder);
    for (const char* const name : {"gold/stack", "gold/intersecting-stack"})
        fs::remove(folder / name / "config.json");
    fs::copy(folder / "gold", folder / "new", fs::copy_options::recursive);
    CHECK(shell(folder, "pushfactor check gold --against new").out ==
          "10 pictures are as expected; see out/check/index.html\n");
    fs::copy_file(folder / "gold/stack/frame_000004.png", folder / "new/stack/frame_000001.png",
                  fs::copy_options::overwrite_existing);
    fs::rename(folder / "new/stack/frame_000002.png", folder / "new/stack/more.png");
    const Ended ended = shell(folder, "pushfactor check gold --against new");
    CHECK(ended.status == 3);
    CHECK(has_line(ended.out, "gold/stack/frame_000001.png: "));
    CHECK(has_line(ended.out, "gold/stack/frame_000002.png: missing"));
    CHECK(has_line(ended.out, "gold/stack/more.png: unexpected"));
    check_page(folder.read("out/check/index.html"));
}

TEST_CASE("check refuses what it cannot check by name") {
    const Folder folder;
    render_gold(folder);
    fs::create_directory(folder / "empty");
    const auto refused = [&](const std::string& arguments, const std::string& words) {
        const Ended ended = shell(folder, "pushfactor check " + arguments);
        INFO(arguments << ": " << ended.err);
        CHECK(ended.status == 2);
        CHECK(lines_of(ended.err).size() == 1);
        CHECK(ended.err.find(words) != std::string::npos);
    };
    refused("", "a folder of expected pictures is missing");
    refused("none", "check none: must be a folder");
    refused("empty", "check empty: must have a config.json");
    refused("gold --tolerance 300", "--tolerance 300: must be LEVELS or LEVELS:SHARE%");
    refused("gold --tolerance 2:0.2", "--tolerance 2:0.2: must be");
    refused("gold --flip 2", "--flip 2: must be from 0 to 1");
    refused("gold --flip 0.1 --tolerance 2", "--flip: must be given without --tolerance");
    refused("gold --physics near", "--physics near: must be hash, off, or metres");
    refused("gold empty --against gold", "--against gold: must be with one folder");
    refused("gold --against gold --update", "--update: must be without --against");
    refused("empty --against gold", "check empty: must have PNG files");

    replace(folder, "gold/stack/summary.json", "\"program\": \"", "\"program\": \"99.");
    const Ended newer = shell(folder, "pushfactor check gold");
    CHECK(newer.status == 3);
    CHECK(newer.out.find("summary.json: made_with.program 99.0.1.0") != std::string::npos);
    const Ended report = shell(folder, "pushfactor report cost --quick --junit verdicts.xml");
    CHECK(report.status == 2);
    CHECK(report.err == "pushfactor: --junit verdicts.xml: must be with report stability, which judges\n");
}

TEST_CASE("check finds each of forty planted differences, and passes nothing that it did not compare") {
    const Folder folder;
    render_gold(folder);
    // A picture with opacity: white, which becomes transparent.
    const std::string opaque =
        std::string("import struct, zlib\n") +
        "def png(name, alpha, n=4, c=255):\n"
        "    part = lambda t, d: struct.pack('>I', len(d)) + t + d + struct.pack('>I', zlib.crc32(t + d))\n"
        "    rows = (b'\\0' + bytes([c, c, c, alpha]) * n) * n\n"
        "    open(name, 'wb').write(b'\\x89PNG\\r\\n\\x1a\\n' + part(b'IHDR', struct.pack('>IIBBBBB', n, n, 8, 6, "
        "0, 0, 0))"
        " + part(b'IDAT', zlib.compress(rows)) + part(b'IEND', b''))\n";
    folder.write("png.py", opaque);
    const auto status = [&](const std::string& change, const std::string& options) {
        const Ended ended =
            shell(folder, "rm -rf now && cp -r gold now && { " + change + "; } && pushfactor check " + options);
        return ended;
    };
    struct Planted {
        std::string change, said;
        int status = 3;
    };
    const std::string frame = "now/stack/frame_000001.png", python = "python3 -c \"exec(open('png.py').read()); ";
    std::vector<Planted> planted{
        {"rm " + frame, "frame_000001.png: missing"},
        {": > " + frame, "frame_000001.png: an empty file"},
        {"head -c 500 gold/stack/frame_000001.png > " + frame, "not a whole PNG file"},
        {"printf 'version https://git-lfs.github.com/spec/v1\\n' > " + frame, "git lfs pull"},
        {"echo text > " + frame, "not a whole PNG file"},
        {"cp gold/stack/frame_000002.png " + frame, "frame_000001.png: "},
        {"cp gold/stack/frame_000003.png " + frame, "frame_000001.png: "},
        {"cp gold/intersecting-stack/frame_000001.png " + frame, "frame_000001.png: "},
        {"mv " + frame + " now/stack/other.png", "frame_000001.png: missing"},
        {"mv " + frame + " now/stack/frame_000001.PNG", "frame_000001.png: missing"},
        {"rm " + frame + "; ln -s nowhere " + frame, "frame_000001.png: missing"},
        {"ln -sf frame_000002.png " + frame, "frame_000001.png: "},
        {python + "png('" + frame + "', 255)\"", "another size"},
        {python + "png('" + frame + "', 0)\"", "another size"},
        {"rm now/stack/summary.json", "stack: physics: not compared"},
        {"echo '{}' > now/stack/summary.json", "stack: "},
        {"echo nonsense > now/stack/summary.json", "is not JSON"},
        {"sed -i 's/\"state_hash\": \"./\"state_hash\": \"x/' now/stack/summary.json", "physics: state hash"},
        {"sed -i '/state_hash/d' now/stack/summary.json", "physics: state hash"},
        {"sed -i 's/\"beta\": 0.2/\"beta\": 0.6/' now/stack/config.json", "options: beta"},
        {"sed -i 's/\"beta\": 0.2/\"beta\": 0.6/' now/stack/summary.json", "options: beta"},
        {"sed -i 's/\"dt\": \"1.60\"/\"dt\": \"1\\/120\"/' now/stack/config.json", "physics: state hash"},
        {"sed -i 's/\"solver\": \"auto\"/\"solver\": \"pgs\"/' now/stack/config.json", "options: solver"},
        {"sed -i 's/\"caption\"/\"kaption\"/; s/\"size\"/\"sise\"/' now/stack/config.json", "unknown option"},
        {"sed -i 's/160x90/160x92/' now/stack/config.json", "another size"},
        {"sed -i 's/\"fps\": 10/\"fps\": 20/' now/stack/config.json", "missing"},
        {"sed -i 's/\"seconds\": 0.4/\"seconds\": 0.6/' now/stack/config.json", "missing"},
        {"echo '{' > now/stack/config.json", "stack: folder: "},
        {"echo '{\"scene\": \"nosuch\"}' > now/stack/config.json", "stack: folder: "},
        {"echo '{}' > now/stack/config.json", "stack: folder: "},
    };
    for (const Planted& one : planted) {
        const Ended ended = status(one.change, "now --tolerance 0");
        INFO(one.change << ": " << ended.out << ended.err);
        CHECK(ended.status == one.status);
        CHECK(ended.out.find(one.said) != std::string::npos);
        CHECK(ended.err.find("intersecting-stack: ") == std::string::npos);
    }
    const std::string two = "rm -rf a b; mkdir a b; ";
    const std::vector<Planted> against{
        {two + python + "png('a/p.png', 255); png('b/p.png', 0)\"", "p.png: opacity"},
        {two + python + "png('a/p.png', 255); png('b/p.png', 254)\"", "p.png: opacity"},
        {two + python + "png('a/p.png', 128, c=0); png('b/p.png', 255, c=127)\"", "p.png: "},
        {two + python + "png('a/p.png', 255, c=0); png('b/p.png', 255, c=1)\"", "p.png: "},
        {two + python + "png('a/p.png', 255); png('b/p.png', 255, 5)\"", "another size"},
        {two + ": > a/p.png; : > b/p.png", "p.png: an empty file"},
        {two + "echo x > a/p.png; echo x > b/p.png", "not a whole PNG file"},
        {two + python + "png('a/p.png', 255)\"", "p.png: missing"},
        {two + python + "png('a/p.PNG', 255); png('b/p.PNG', 255, c=9)\"", "p.PNG: "},
        {two + "mkdir c d; ln -s ../c a/l; ln -s ../d b/l; " + python +
             "png('c/p.png', 255); png('d/p.png', 255, c=9)\"",
         "l/p.png: "},
    };
    for (const Planted& one : against) {
        const Ended ended = status(one.change, "a --against b --tolerance 0");
        INFO(one.change << ": " << ended.out << ended.err);
        CHECK(ended.status == 3);
        CHECK(ended.out.find(one.said) != std::string::npos);
    }
    CHECK(planted.size() + against.size() == 40);
    CHECK(status(":", "now").status == 0);
    CHECK(status("rm now/stack/summary.json", "now --allow-not-compared").status == 0);
    CHECK(status("rm now/stack/summary.json", "now --physics 1e-6").status == 3);
    CHECK(status("mkdir -p " + std::string(100, 'a') + "/" + std::string(100, 'b') + "/" + std::string(100, 'c') +
                     " && mv now " + std::string(100, 'a') + "/" + std::string(100, 'b') + "/" +
                     std::string(100, 'c'),
                 std::string(100, 'a'))
              .status == 0);
}

TEST_CASE(
    "check goes on after a folder that it cannot read, and is no success over pictures that no run explains") {
    const Folder folder;
    render_gold(folder);
    const std::string trajectory =
        "pushfactor render chain --out gold/chain --trajectory gold/chain/trajectory.csv ";
    require_success(folder, trajectory + small);
    require_success(folder, "cp -r gold damaged; sed -i '4s/.*/damaged/' damaged/chain/trajectory.csv");
    const Ended damaged = shell(folder, "pushfactor check damaged --physics 1e-6 --allow-not-compared");
    INFO(damaged.out << damaged.err);
    CHECK(damaged.status == 3);
    CHECK(has_line(damaged.out, "damaged/chain: folder: --physics 1e-06: damaged/chain/trajectory.csv: line 4"));
    CHECK(damaged.err.find("1 of 1 run differs") != std::string::npos);

    fs::remove(folder / "gold/chain/config.json");
    const std::string said = "gold/chain: folder: not compared: there is no config.json";
    const Ended alone = shell(folder, "pushfactor check gold");
    CHECK(alone.status == 3);
    CHECK(has_line(alone.out, said));
    CHECK(shell(folder, "pushfactor check gold --allow-not-compared").status == 0);
    const Ended update = shell(folder, "pushfactor check gold --update");
    CHECK(update.status == 3);
    CHECK(has_line(update.out, "gold/chain: cannot be updated"));

    fs::remove_all(folder / "gold/chain");
    CHECK(shell(folder, "pushfactor check gold --out gold/page && pushfactor check gold --out gold/page").status ==
          0);
    fs::remove_all(folder / "gold/page");
    fs::copy_file(folder / "gold/stack/frame_000000.png", folder / "gold/stack/more.png");
    for (const char* const options : {"", " --update", " --against gold/intersecting-stack --tolerance 255"}) {
        const Ended ended = shell(folder, std::string("pushfactor check gold/stack") + options);
        INFO(options << ended.out << ended.err);
        CHECK(ended.status == 3);
    }
    CHECK(shell(folder, "pushfactor check gold --allow-not-compared").status == 0);
}
