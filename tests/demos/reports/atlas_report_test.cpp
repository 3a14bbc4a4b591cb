// The stability atlas command: all files; interrupted and resumed; each command of its table repeated. Its pieces
// are tested in pieces_test.cpp, maps of one's own in grid_test.cpp.
#include "demos/base/text/json.h"
#include "tests/catch.h"
#include "tests/demos/csv.h"
#include "tests/demos/pages/check_page.h"
#include "tests/demos/program.h"

using namespace pushfactor::tests;

namespace {

constexpr const char* quick_map = "pushfactor report atlas --quick --only overlap_beta_persistent --out .";

}  // namespace

TEST_CASE("one command makes a table, maps and a page, a command of the table gives its outcome and number again") {
    const Folder folder;
    const Ended ended = shell(folder, quick_map);
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    CHECK(ended.out == "./index.html\n");
    check_page(folder.read("index.html"));
    CHECK(folder.read("index.html").find("<img src=\"overlap_beta_persistent.png\"") != std::string::npos);
    CHECK(std::filesystem::file_size(folder / "overlap_beta_persistent.png") > 10000);

    const std::vector<std::string> lines = lines_of(folder.read("atlas.csv"));
    REQUIRE(lines.size() == 2 + 9);
    CHECK(lines[0].starts_with("# pushfactor "));
    CHECK(lines[1] == "map,x_name,x,y_name,y,outcome,measure,value,command");
    for (const std::size_t number : {2u, 6u, 10u}) {  // little overlap and beta, the middle, much of both
        const std::vector<std::string> row = fields_of(lines[number]);
        INFO(lines[number]);
        REQUIRE(row.size() == 9);
        REQUIRE(shell(folder, row[8] + " --summary again.json").status == 0);
        const auto summary = pushfactor::demos::parse_json(folder.read("again.json"));
        CHECK(summary["outcome"] == row[5]);
        CHECK(summary[row[6]] == std::stod(row[7]));
    }
    CHECK(fields_of(lines[2])[5] == "rest");
    CHECK(fields_of(lines[10])[5] == "fly");
}

TEST_CASE("maps that are complete stay when another one is asked for") {
    const Folder folder;
    REQUIRE(shell(folder, quick_map).status == 0);
    const Ended ended = shell(folder, "pushfactor report atlas --quick --only overlap_beta_single_frame --out .");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    CHECK(lines_of(folder.read("atlas.csv")).size() == 2 + 18);
    CHECK(folder.read("index.html").find("overlap_beta_persistent.png") != std::string::npos);
}

TEST_CASE("an interrupted atlas ends with status 1 and whole pieces, from which it goes on") {
    const Folder folder;
    const Ended ended = stopped_when(folder, "ls pieces/*/*/*.json", "report atlas --out .");
    INFO(ended.err);
    CHECK(ended.status == 1);
    CHECK(ended.err.find("the same command resumes from there") != std::string::npos);
    for (const std::string& file : folder.files()) {
        CHECK(file.starts_with("pieces/"));
        CHECK_NOTHROW(pushfactor::demos::parse_json(folder.read(file)));
    }
    const auto count = folder.files().size();
    CHECK(shell(folder, quick_map).status == 0);
    CHECK(folder.files().size() > count);
}

TEST_CASE("without gnuplot the atlas has its table, and the page says what to install") {
    const Folder folder;
    const Ended ended = shell(folder, std::string("PATH=/nowhere ") + quick_map);
    INFO(ended.err);
    CHECK(ended.status == 0);
    std::filesystem::remove_all(folder / "pieces");
    CHECK(folder.files() == std::vector<std::string>{"atlas.csv", "index.html", "overlap_beta_persistent.dat"});
    CHECK(folder.read("index.html").find("apt install gnuplot-nox") != std::string::npos);
}

TEST_CASE("the atlas refuses what it does not know in one line") {
    check_refused("report atlas --only height", "--only height: must be one of mass_ratio_iterations, ");
    check_refused("report atlas --only hight_iterations", "did you mean height_iterations?");
    check_refused("report atlas --export x", "--export x: must be with report error");
    CHECK(run_program("report atlas --quick --out /dev/null/x").status == 4);
}
