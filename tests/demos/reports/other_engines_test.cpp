// Other engines beside our methods on the page of report error.
#include "demos/reports/error/error.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::demos::reports::error;
using namespace pushfactor::tests;

namespace {

ErrorPoint point(const std::string& method, const std::string& value, double error, double cpu,
                 const std::string& outcome = "rest") {
    return {.scene = "stack",
            .method = method,
            .differences = "",
            .knob = "sweeps",
            .value = value,
            .errors = {{"rest_position_rms_m", error}},
            .multiply_adds = 1.0,
            .cpu = {.min = cpu, .median = cpu, .p95 = cpu, .first_two_seconds = cpu, .last_second = cpu},
            .outcome = outcome,
            .failed = means_failure(outcome)};
}

WorkLine line(const std::string& name, std::vector<WorkPoint> points) {
    return {.name = name, .colour = "blue", .points = std::move(points)};
}

}  // namespace

TEST_CASE("points of other engines are read as error.csv states them") {
    const std::vector<ErrorPoint> written{point("Bullet, sweeps", "10", 0.5, 2e-3),
                                          point("ODE", "1", 1e-3, 1e-2, "fall")};
    const Folder folder;
    folder.write("others.csv", csv_text(table_of(written)));
    const std::vector<ErrorPoint> read = read_error_points(folder / "others.csv");
    REQUIRE(read.size() == 2);
    CHECK(read[0].method == "Bullet, sweeps");
    CHECK(read[0].errors.front().name == "rest_position_rms_m");
    CHECK(read[0].errors.front().value == 0.5);
    CHECK(read[0].cpu.median == 2e-3);
    CHECK(!read[0].failed);
    CHECK(read[1].failed);
    CHECK(about(read, "stack", "rest_position_rms_m").size() == 2);
    CHECK(about(read, "stack", "moved_rms_m").empty());
    CHECK(about(read, "wall", "rest_position_rms_m").empty());
}

TEST_CASE("beside other engines stand those of our methods that no other of ours beats") {
    const std::vector<WorkLine> ours{line("slow", {{1e-3, 5.0, "1"}}),
                                     line("good", {{1e-2, 1.0, "1"}, {1e-4, 3.0, "2"}}),
                                     line("blown", {{1e-9, 0.1, "1", true}})};
    const std::vector<ErrorPoint> others{
        point("Bullet, sweeps", "1", 1e-1, 0.5), point("Bullet, sweeps", "9", 1e-2, 4.0),
        point("Bullet, small steps", "2", 1e-3, 2.0), point("ODE, step", "1", 1e-6, 9.0)};
    const std::vector<WorkLine> lines = lines_beside(ours, others);
    REQUIRE(lines.size() == 4);
    CHECK(lines[0].name == "good");
    CHECK(lines[1].points.size() == 2);
    CHECK(lines[1].mark == lines[2].mark);  // one engine
    CHECK(lines[1].dash != lines[2].dash);
    CHECK(lines[3].mark != lines[1].mark);

    const TextTable table = who_is_faster(ours, others);
    REQUIRE(table.size() == 4);
    CHECK(table[1] ==
          std::vector<std::string>{"Bullet, sweeps, sweeps 9", "0.01", "4e+03 ms", "1e+03 ms", "good, 1"});
    CHECK(table[2][3] == "3e+03 ms");
    CHECK(table[3][3] == "not reached");
}

TEST_CASE("report error draws other engines beside ours, and refuses what is no error.csv") {
    const Folder folder;
    std::vector<ErrorPoint> others{point("Bullet, sweeps", "10", 0.5, 2e-3)};
    others[0].scene = "sphere_column";
    others[0].errors = {{"force_error_first_step", 0.5}};
    folder.write("others.csv", csv_text(table_of(others)));
    const std::string command = "pushfactor report error --quick --only sphere_column --out . --beside ";
    const Ended ended = shell(folder, command + "others.csv");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    CHECK(std::filesystem::exists(folder / "beside_sphere_column.png"));
    CHECK(folder.read("index.html").find("Bullet, sweeps, sweeps 10") != std::string::npos);

    others[0].scene = "stack";
    folder.write("elsewhere.csv", csv_text(table_of(others)));
    const Ended elsewhere = shell(folder, command + "elsewhere.csv");
    CHECK(elsewhere.status == 2);
    CHECK(elsewhere.err.find("--beside elsewhere.csv: must have points on scenes of the report") !=
          std::string::npos);

    folder.write("wrong.csv", "a,b\n1,2\n");
    const Ended refused = shell(folder, command + "wrong.csv");
    CHECK(refused.status == 2);
    CHECK(refused.err.find("--beside wrong.csv: line 1: must be scene,method,") != std::string::npos);
}
