// Maps of one's own: `report atlas --grid`.
#include "demos/base/text/json.h"
#include "demos/reports/atlas/atlas.h"
#include "tests/catch.h"
#include "tests/demos/csv.h"
#include "tests/demos/pages/check_page.h"
#include "tests/demos/program.h"

using namespace pushfactor::tests;
using namespace pushfactor::demos::reports;

namespace {

std::vector<std::string> values_of(const std::string& axis) {
    return atlas::grid_map({.scene = "stack", .x = axis, .y = "seconds=0.5,1", .measure = "max_off_axis_m"})
        .x.values;
}

}  // namespace

TEST_CASE("values of an axis are exact steps, equal factors to four digits, or a list in ascending order") {
    using Values = std::vector<std::string>;
    CHECK(values_of("count=2:9:2") == Values{"2", "4", "6", "8"});
    CHECK(values_of("beta=0.1:0.5:0.1") == Values{"0.1", "0.2", "0.3", "0.4", "0.5"});
    CHECK(values_of("gap=log:0.01:1:3") == Values{"0.01", "0.1", "1"});
    CHECK(values_of("count=log:1:10:6") == Values{"1", "2", "3", "4", "6", "10"});  // whole
    CHECK(values_of("dt=1/30,1/120,1/60") == Values{"1/120", "1/60", "1/30"});
    CHECK(values_of("solver=pgs,direct") == Values{"pgs", "direct"});
    CHECK(values_of("count=log:1:3:10") == Values{"1", "2", "3"});
}

TEST_CASE("a map over a scene file has page, table and replays, and its commands give the numbers again") {
    const Folder folder;
    REQUIRE(shell(folder, "pushfactor scene stack --count 2 > my.json").status == 0);
    const std::string report =
        "pushfactor report atlas --grid my.json --x beta=0.2:1:0.4 --y push=persistent,single-frame "
        "--measure energy_final_j --set seconds=0.5 --replays 0.6:single-frame ";
    const Ended ended = shell(folder, report + "--out out");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    check_page(folder.read("out/index.html"));
    CHECK(folder.read("out/index.html").find("<img src=\"grid.png\"") != std::string::npos);
    CHECK(folder.read("out/index.html").find("cells/beta_0.6_push_single-frame.html") != std::string::npos);
    CHECK(folder.read("out/cells/beta_0.6_push_single-frame.html").find("<html") != std::string::npos);
    const auto lines = lines_of(folder.read("out/atlas.csv"));
    REQUIRE(lines.size() == 2 + 6);
    const auto row = fields_of(lines[4]);
    REQUIRE(row.size() == 9);
    REQUIRE(shell(folder, row[8] + " --summary again.json").status == 0);
    const auto summary = pushfactor::demos::parse_json(folder.read("again.json"));
    CHECK(summary["energy_final_j"] == std::stod(row[7]));
    CHECK(summary["outcome"] == row[5]);

    // In shards, from another folder with the same file: its content counts, not its path.
    REQUIRE(shell(folder, report + "--out a --shard 1/2 && mkdir -p b && cp my.json b && cd b && " + report +
                              "--out . --shard 2/2 && cd .. && pushfactor report merge a b --out merged")
                .status == 0);
    for (const char* const file :
         {"atlas.csv", "index.html", "grid.png", "cells/beta_0.6_push_single-frame.html"}) {
        CHECK(folder.read(std::string("merged/") + file) == folder.read(std::string("out/") + file));
    }
}

TEST_CASE("a map of one's own does not replace the page of the atlas") {
    const Folder folder;
    const Ended ended = shell(folder, "pushfactor report atlas --grid stack --x count=1,2 --y seconds=0,0.1");
    CHECK(ended.out == "out/report-atlas-grid/index.html\n");
}

TEST_CASE("a cell whose summary lacks the number is empty and keeps its outcome") {
    const Folder folder;
    const Ended ended = shell(folder,
                              "pushfactor report atlas --grid stack --x count=2,3 --y beta=0.1,0.2 "
                              "--measure drift_after_10_s_m --set seconds=0.1 --out .");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    CHECK(fields_of(lines_of(folder.read("atlas.csv")).back())[7].empty());
}

TEST_CASE("a grid that no run accepts is refused in one line") {
    const std::string axes = "--x count=2:4:1 --y beta=0.1,0.2 ";
    check_refused("report atlas --grid stak " + axes, "stack");
    check_refused("report atlas --grid stack --x count=2:4:1",
                  "must be with --x OPTION=VALUES and --y OPTION=VALUES");
    check_refused("report atlas --x count=2:4:1", "--x count=2:4:1: must be with --grid SCENE");
    check_refused("report error --grid stack " + axes, "--grid stack: must be with report atlas");
    check_refused("report atlas --grid stack --x coun=2:4:1 --y beta=0.1,0.2", "did you mean count?");
    check_refused("report atlas --grid stack --x count=2:4 --y beta=0.1,0.2", "must be OPTION=FROM:TO:STEP");
    check_refused("report atlas --grid stack --x count=4:2:1 --y beta=0.1,0.2", "must have 2 to 10000 values");
    check_refused("report atlas --grid stack --x count=log:0:2:5 --y beta=0.1,0.2", "must be 0 < FROM < TO");
    check_refused("report atlas --grid stack --x count=2.5,3 --y beta=0.1,0.2", "--count 2.5");
    check_refused("report atlas --grid stack " + axes + " --set seconds=1 --set seconds=2",
                  "--set seconds=2: must be without --set seconds=1");
    check_refused("report atlas --grid stack " + axes + " --set beta=0.3", "must be without --set beta=0.3");
    check_refused("report atlas --grid stack --x count=2,3 --y count=2,3",
                  "must be another option than that of --x");
    check_refused("report atlas --grid stack --measure outcom " + axes, "--measure outcom: must be one of ");
    check_refused("report atlas --grid stack --replays 9:0.1 " + axes, "--replays 9:0.1: must be all, or X:Y");
    check_refused("report atlas --grid stack --set nonsense=1 " + axes,
                  "--set nonsense=1: nonsense must be one of");
    check_refused("report atlas --grid stack --quick " + axes, "--quick: must be without --grid");
}
