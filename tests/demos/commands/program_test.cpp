// The program as seen by a user: its answers, and its messages for bad input.
#include "tests/demos/program.h"

#include "demos/base/text/json.h"
#include "tests/catch.h"
#include "tests/skip.h"

#include <algorithm>
#include <sstream>
#include <vector>

using namespace pushfactor::tests;

namespace {

// One line on standard error that begins with the program's name, nothing on standard output.
void check_refusal(const std::string& arguments, int status, const std::vector<const char*>& said) {
    INFO("pushfactor " << arguments);
    const Ended ended = run_program(arguments);
    CHECK(ended.status == status);
    CHECK(ended.out.empty());
    CHECK(ended.err.starts_with("pushfactor: "));
    CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
    for (const char* words : said) CHECK_THAT(ended.err, Catch::Contains(words));
}

}  // namespace

TEST_CASE("the program says its version, its help at every level and its scenes") {
    CHECK(run_program("--version").out.starts_with("pushfactor "));
    for (const char* level : {"--help", "run --help", "render --help", "list --help"}) {
        const Ended help = run_program(level);
        CHECK(help.status == 0);
        CHECK_THAT(help.out, Catch::Contains("Exit status"));
    }
    CHECK_THAT(run_program("run --help").out, Catch::Contains("--beta") && Catch::Contains("--jitter"));
    const Ended list = run_program("list");
    CHECK(list.status == 0);
    CHECK_THAT(list.out, Catch::Contains("intersecting-stack") &&
                             Catch::Contains("made of: 50 bodies, gravity, 50 distances\n"));
    CHECK(run_program("list --names").out ==
          "stack\nintersecting-stack\nfunnel\npendulum-grid\npendulum-wave\nchain\nheavy-on-light\n"
          "arch\ndominoes\nplatonic\n");
}

TEST_CASE("the version names a commit of these sources, or says that they are no checkout") {
    const Ended version = run_program("--version");
    CHECK(version.status == 0);
    const std::string marker = ", commit ";
    const auto at = version.out.find(marker);
    REQUIRE(at != std::string::npos);
    const std::string commit = version.out.substr(at + marker.size(), 12);
    if (commit.starts_with("unknown")) return skip("these sources are no checkout");
    INFO(version.out);
    CHECK(commit.find_first_not_of("0123456789abcdef") == std::string::npos);
    CHECK(shell(Folder(), "git -C '" PUSHFACTOR_SOURCE_DIR "' cat-file -e " + commit + "^{commit}").status == 0);
}

TEST_CASE("the build writes down the commit that is checked out, and only when it is another one") {
    const Folder folder;
    if (shell(folder, "git --version").status != 0) return skip("git is not installed");
    const auto commit_of = [&folder](const std::string& source) {
        const std::string script = "cmake -D SOURCE=" + source + " -D HEADER=\"$PWD/commit.h\" -P '" +
                                   PUSHFACTOR_SOURCE_DIR "/demos/write_commit.cmake'";
        CHECK(shell(folder, script).status == 0);
        return folder.read("commit.h");
    };
    const std::string in_tree = "cd tree && git -c user.name=a -c user.email=a@b -c commit.gpgsign=false ";
    REQUIRE(shell(folder, "mkdir -p tree/below && cd tree && git init -q && echo 1 >file && git add file").status ==
            0);
    REQUIRE(shell(folder, in_tree + "commit -q -m one").status == 0);
    const std::string first = commit_of("\"$PWD/tree\"");
    const std::string named = shell(folder, "git -C tree rev-parse --short=12 HEAD").out.substr(0, 12);
    CHECK(first == "#define PUSHFACTOR_COMMIT \"" + named + "\"\n");

    REQUIRE(shell(folder, "touch -d 2001-01-01 commit.h").status == 0);
    CHECK(commit_of("\"$PWD/tree\"") == first);
    CHECK(shell(folder, "test commit.h -ot tree/file").status == 0);  // not written again

    REQUIRE(shell(folder, "echo 2 >tree/file").status == 0);
    CHECK(commit_of("\"$PWD/tree\"") == "#define PUSHFACTOR_COMMIT \"" + named + "-dirty\"\n");
    REQUIRE(shell(folder, in_tree + "commit -q -a -m two").status == 0);
    CHECK(commit_of("\"$PWD/tree\"") != first);
    // Within another repository's checkout, and in none.
    CHECK(commit_of("\"$PWD/tree/below\"") == "#define PUSHFACTOR_COMMIT \"unknown\"\n");
    CHECK(commit_of("\"$PWD\"") == "#define PUSHFACTOR_COMMIT \"unknown\"\n");
}

TEST_CASE("unknown words are refused with the nearest known one") {
    check_refusal("run stak", 2, {"scene stak", "stack, intersecting-stack", "scene file", "did you mean stack?"});
    check_refusal("run stack --sede 3", 2, {"--sede", "did you mean --seed?"});
    check_refusal("run stack --foo", 2, {"--foo: unknown option"});
    check_refusal("rum stack", 2, {"rum", "did you mean run?"});
    check_refusal("", 2, {"a command is missing"});
    check_refusal("run", 2, {"a scene is missing"});
    check_refusal("run stack intersecting-stack", 2, {"one scene at a time"});
}

TEST_CASE("an option that the scene lacks is refused with those that it has") {
    check_refusal("run intersecting-stack --jitter 0.01", 2,
                  {"--jitter 0.01", "intersecting-stack", "--count, --gap"});
}

TEST_CASE("values out of range are refused by option, value and what is allowed") {
    check_refusal("run stack --dt 0", 2, {"--dt 0", "must be", "1/60"});
    check_refusal("run stack --dt nan", 2, {"--dt nan", "must be"});
    check_refusal("run stack --dt 1/0", 2, {"--dt 1/0", "must be"});
    check_refusal("run stack --count -1", 2, {"--count -1", "from 1 to 1000"});
    check_refusal("run stack --count 2.5", 2, {"--count 2.5", "whole number"});
    check_refusal("run stack --beta 2", 2, {"--beta 2", "from 0 to 1"});
    check_refusal("run stack --beta", 2, {"--beta"});
    check_refusal("run stack --restitution 1.0001", 2, {"--restitution 1.0001", "from 0 to 1"});
    check_refusal("run stack --max-push-speed 0", 2, {"--max-push-speed 0", "above 0"});
    check_refusal("run stack --preset best", 2, {"--preset best", "default, exact, paper"});
    check_refusal("run stack --solver magic", 2, {"--solver magic", "auto, pgs, direct, dense"});
    check_refusal("run stack --tolerance 1e-10/1e-8", 2, {"--tolerance", "LOW <= HIGH"});
    check_refusal("run stack --seconds -1", 2, {"--seconds -1"});
    check_refusal("run stack --friction inf", 2, {"--friction inf"});
    check_refusal("render stack --size 0x0", 2, {"--size 0x0", "from 16 to 4096"});
    check_refusal("render stack --fps 1e9", 2, {"--fps 1e9", "up to 1e6"});
    check_refusal("render stack --play-speed 1e9", 2, {"--play-speed 1e9", "up to 1e6"});
    check_refusal("render stack --camera orbit:1e9", 2, {"orbit:1e9", "up to 1e4"});
    check_refusal("run stack --iterations 25.5", 2, {"--iterations 25.5", "whole number"});
    check_refusal("run stack --iterations 1e10", 2, {"--iterations 1e10", "whole number"});
    check_refusal("run nowhere.json --count 5", 2, {"nowhere.json: cannot be read"});
}

TEST_CASE("a whole number may be written as a decimal, in options as in parameters of scenes") {
    const Folder folder;
    const std::string run = "pushfactor run stack --seconds 0.1 ";
    CHECK(shell(folder, run + "--count 4.0 --iterations 3e1").out ==
          shell(folder, run + "--count 4 --iterations 30").out);
    CHECK(shell(folder, run + "--iterations 3e1").status == 0);
}

TEST_CASE("a frame that falls between two steps is refused with the rates and times that fit") {
    check_refusal("render stack --fps 25", 2, {"--fps 25", "30", "20"});
    check_refusal("render stack --at 0.51", 2, {"--at 0.51", "0.5", "31/60"});
    check_refusal("render stack --at 11", 2, {"--at 11", "within the 10 s"});
    check_refusal("run stack --fps 25 --trajectory x.csv", 2, {"--fps 25"});
}

TEST_CASE("outputs that cannot be written end with status 4 and name option and path") {
    check_refusal("run stack --seconds 1 --csv /proc/no/x.csv", 4, {"--csv /proc/no/x.csv", "No such file"});
    check_refusal("run stack --seconds 1 --junit /proc/no/x.xml", 2, {"--junit"});
    check_refusal("run stack --seconds 1 --csv /dev/full", 4, {"--csv /dev/full", "No space left"});
    check_refusal("run stack --seconds 1 --summary .", 4, {"--summary .", "directory"});
    check_refusal("render stack --at 0 --out /dev/null/frames", 4, {"--out /dev/null/frames: Not a directory"});
    check_refusal("report cost --quick --out /dev/null/page", 4, {"--out /dev/null/page: Not a directory"});
}

TEST_CASE("the last good state of a run is not written beside a device that takes its outputs") {
    const Folder folder;
    folder.write("heavy.json", R"({"version": 1, "gravity_m_per_s2": [0, -1e200, 0],
        "bodies": [{"name": "ball", "shape": "sphere", "radius_m": 1, "mass_kg": 1}]})");
    const Ended ended = shell(folder, "pushfactor run heavy.json --summary /dev/null --csv /dev/zero");
    INFO(ended.err);
    CHECK(ended.status == 5);
    CHECK(folder.files() == std::vector<std::string>{"heavy-last-good.json", "heavy.json"});
}

TEST_CASE("a summary holds the fields that design and README promise") {
    const Ended ended = run_program("run stack --seconds 1");
    CHECK(ended.status == 0);
    for (const char* field : {"scene",
                              "preset",
                              "options",
                              "steps",
                              "simulated_seconds",
                              "bodies",
                              "state_hash",
                              "outcome",
                              "max_penetration_m",
                              "max_length_error_m",
                              "max_speed_m_per_s_last_second",
                              "max_upward_speed_m_per_s",
                              "residual_m_per_s_median",
                              "residual_m_per_s_worst",
                              "unsolved_steps",
                              "first_unsolved_step",
                              "contradicting_steps",
                              "islands",
                              "energy_initial_j",
                              "energy_final_j",
                              "energy_gain_j",
                              "max_off_axis_m",
                              "drift_after_10_s_m",
                              "lean_time_s",
                              "fall_time_s",
                              "heights_m"}) {
        CHECK_THAT(ended.out, Catch::Contains("\"" + std::string(field) + "\":"));
    }
    CHECK_THAT(ended.out, !Catch::Contains("cpu_us"));
    CHECK_THAT(run_program("run stack --seconds 1 --timing").out, Catch::Contains("cpu_us_per_step_median"));
}

TEST_CASE("REFERENCE.md is what the program prints about its commands and options") {
    INFO("to update it: build/release/pushfactor --reference > demos/REFERENCE.md");
    const Ended ended = run_program("--reference");
    CHECK(ended.status == 0);
    CHECK((ended.out == read_file(PUSHFACTOR_SOURCE_DIR "/demos/REFERENCE.md")));
}

TEST_CASE("FORMATS.md names every column of the CSV files and every key of a summary") {
    const std::string page = read_file(PUSHFACTOR_SOURCE_DIR "/demos/FORMATS.md");
    const auto check_named = [&page](const std::string& name) {
        CHECK_THAT(page, Catch::Contains("`" + name + "`"));
    };
    for (const char* const option : {"--csv", "--trajectory", "--rows"}) {
        const Ended ended =
            run_program("run stack --seconds 0 --timing --summary /dev/null " + std::string(option) + " -");
        std::istringstream header(ended.out.substr(0, ended.out.find('\n')));
        int columns = 0;
        for (std::string column; std::getline(header, column, ','); ++columns) check_named(column);
        CHECK(columns > 10);
    }
    for (const char* const run : {"stack --timing", "funnel --restitution 0.5"}) {
        const auto summary =
            pushfactor::demos::parse_json(run_program("run --seconds 0.1 " + std::string(run)).out);
        for (const auto& [key, value] : summary.items()) check_named(key);
        for (const char* const key : {"islands", "impacts", "at_rest", "substeps"}) {
            if (!summary.contains(key)) continue;
            for (const auto& [part, value] : summary[key].items()) check_named(part);
        }
    }
}

TEST_CASE("the table in SCENES.md is what the program lists") {
    const std::string page = read_file(PUSHFACTOR_SOURCE_DIR "/demos/SCENES.md");
    std::istringstream lines(run_program("list").out);
    int scenes = 0;
    for (std::string name; std::getline(lines, name);) {
        if (name.empty() || name.starts_with(' ')) continue;
        std::string sentence, made_of;
        std::getline(lines, sentence);
        std::getline(lines, made_of);
        ++scenes;
        std::ostringstream row;
        row << "`" << name << "` | " << sentence.substr(4) << " | " << made_of.substr(13) << " |";
        CHECK_THAT(page, Catch::Contains(row.str()));
        CHECK(std::filesystem::exists(std::filesystem::path(PUSHFACTOR_SOURCE_DIR "/assets/pictures") /
                                      (name + ".png")));
    }
    CHECK(scenes == 10);
}
