// The stability atlas command: all files; interrupted and resumed; each command of its table repeated.
#include "demos/text/json.h"
#include "tests/catch.h"
#include "tests/demos/csv.h"
#include "tests/demos/pages/check_page.h"
#include "tests/demos/program.h"

using namespace pushfactor::tests;

namespace {

constexpr const char* quick_map = "pushfactor report atlas --quick --only overlap_beta_persistent --out .";

std::string quick_csv() {
    const Folder folder;
    const Ended ended = shell(folder, quick_map);
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    return folder.read("atlas.csv");
}

// Four rows, and the fifth as a killed run left it.
std::string cut_short(const std::string& csv) {
    std::size_t end = 0;
    for (int line = 0; line < 6; ++line) end = csv.find('\n', end) + 1;
    return csv.substr(0, end + 20);
}

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
        const auto summary = pushfactor::demos::Json::parse(folder.read("again.json"));
        CHECK(summary["outcome"] == row[5]);
        CHECK(summary[row[6]] == std::stod(row[7]));
    }
    CHECK(fields_of(lines[2])[5] == "rest");
    CHECK(fields_of(lines[10])[5] == "fly");
}

TEST_CASE("an atlas goes on from the lines that are there, without the one that was cut, and ends the same") {
    const std::string whole = quick_csv();
    const Folder folder;
    folder.write("atlas.csv", cut_short(whole));
    const Ended ended = shell(folder, quick_map);
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    CHECK(folder.read("atlas.csv") == whole);
}

TEST_CASE("what is in the table is not run again, and lines of maps that were not asked for stay") {
    // The last line first, with a number that no run gives.
    std::vector<std::string> lines = lines_of(quick_csv());
    std::vector<std::string> row = fields_of(lines.back());
    std::string changed = lines.back();
    changed.replace(changed.find(row[7]), row[7].size(), "12345");
    lines.back() = changed;
    std::swap(lines[2], lines.back());
    std::string text;
    for (const std::string& line : lines) text += line + "\n";

    const Folder folder;
    folder.write("atlas.csv", text);
    const Ended ended = shell(folder, "pushfactor report atlas --quick --only overlap_beta_single_frame --out .");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    const std::vector<std::string> now = lines_of(folder.read("atlas.csv"));
    REQUIRE(now.size() == 2 + 18);
    CHECK(now[10] == changed);
    CHECK(folder.read("index.html").find("overlap_beta_persistent.png") != std::string::npos);
}

TEST_CASE("an interrupted atlas ends with status 1 and whole lines, from which it goes on") {
    const std::string whole = quick_csv();
    const Folder folder;
    folder.write("atlas.csv", cut_short(whole));
    const Ended ended =
        shell(folder, "'" PUSHFACTOR_PROGRAM
                      "' report atlas --out . & "
                      "while [ \"$(wc -l <atlas.csv)\" -lt 9 ]; do sleep 0.05; done; kill -INT $!; wait $!");
    INFO(ended.err);
    CHECK(ended.status == 1);
    CHECK(ended.err.find("the same command resumes from there") != std::string::npos);
    CHECK(folder.files() == std::vector<std::string>{"atlas.csv"});
    const std::string csv = folder.read("atlas.csv");
    CHECK(csv.ends_with("\n"));
    CHECK(lines_of(csv).size() >= 9);
    for (const std::string& line : lines_of(csv)) {
        if (!line.starts_with("#")) CHECK(fields_of(line).size() == 9);
    }
    CHECK(shell(folder, quick_map).status == 0);
    for (const std::string& line : lines_of(whole)) CHECK(folder.read("atlas.csv").find(line) != std::string::npos);
}

TEST_CASE("a table that this atlas did not write is refused in one line and left alone") {
    const std::string whole = quick_csv();
    const std::vector<std::string> lines = lines_of(whole);
    const auto with_row = [&](const std::string& row) { return lines[0] + "\n" + lines[1] + "\n" + row + "\n"; };
    const auto changed = [](std::string text, const std::string& from, const std::string& to) {
        REQUIRE(text.find(from) != std::string::npos);
        return text.replace(text.find(from), from.size(), to);
    };
    for (const std::string& text : {
             std::string(),
             std::string("time,value\n1,2\n"),
             changed(whole, "# pushfactor ", "# pushfactor 9"),
             with_row(lines[2]) + lines[2] + "\n",
             with_row("nothing"),
             with_row(lines[2] + ",more"),
             with_row(changed(lines[2], ",rest,", ",well,")),
             with_row(changed(lines[2], "--seconds 3", "--seconds 4")),
             with_row(changed(lines[2], fields_of(lines[2])[7], "nan")),
             with_row(changed(lines[2], ",beta,0.1,", ",beta,0.15,")),
         }) {
        INFO(text);
        const Folder folder;
        folder.write("atlas.csv", text);
        const Ended ended = shell(folder, quick_map);
        INFO(ended.err);
        CHECK(ended.status == 2);
        CHECK(ended.err.find("atlas.csv: ") != std::string::npos);
        CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
        CHECK(folder.read("atlas.csv") == text);
        CHECK(folder.files() == std::vector<std::string>{"atlas.csv"});
    }
}

TEST_CASE("without gnuplot the atlas has its table, and the page says what to install") {
    const Folder folder;
    const Ended ended = shell(folder, std::string("PATH=/nowhere ") + quick_map);
    INFO(ended.err);
    CHECK(ended.status == 0);
    CHECK(folder.files() == std::vector<std::string>{"atlas.csv", "index.html", "overlap_beta_persistent.dat"});
    CHECK(folder.read("index.html").find("apt install gnuplot-nox") != std::string::npos);
}

TEST_CASE("the atlas refuses what it does not know in one line") {
    check_refused("report atlas --only height", "--only height: must be one of mass_ratio_iterations, ");
    check_refused("report atlas --only hight_iterations", "did you mean height_iterations?");
    check_refused("report atlas --problems x", "--problems x: must be with report error");
    CHECK(run_program("report atlas --quick --out /dev/null/x").status == 4);
}
