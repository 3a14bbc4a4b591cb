// The error report command: all files, the same work twice, and what is refused.
#include "tests/catch.h"
#include "tests/demos/csv.h"
#include "tests/demos/pages/check_page.h"
#include "tests/demos/program.h"

#include <array>
#include <cstdio>
#include <map>
#include <set>

using namespace pushfactor::tests;

namespace {

// All of error.csv but the CPU times.
std::vector<std::vector<std::string>> without_times(const std::string& csv) {
    std::vector<std::vector<std::string>> lines;
    std::istringstream stream(csv);
    std::string line;
    REQUIRE(std::getline(stream, line));
    CHECK(line.starts_with("# pushfactor "));
    while (std::getline(stream, line)) {
        std::vector<std::string> row = fields_of(line);
        REQUIRE(row.size() == 14);
        row.erase(row.begin() + 8, row.begin() + 13);
        lines.push_back(row);
    }
    return lines;
}

// The page begins with the cheapest point of each scene for an error of 1e-6, as a search in error.csv finds it.
void check_answers(const std::string& csv, const std::string& page) {
    const std::size_t answer = page.find("<section"), next = page.find("<section", answer + 1);
    const std::string shown = page.substr(answer, next - answer);
    CHECK(shown.find("Which method reaches which error in which time") != std::string::npos);
    std::map<std::string, std::pair<double, std::string>> cheapest;  // by scene and measure: the first is plotted
    std::map<std::string, std::string> measures;
    std::istringstream stream(csv);
    std::string line;
    std::getline(stream, line);
    std::getline(stream, line);
    while (std::getline(stream, line)) {
        const auto row = fields_of(line);
        measures.emplace(row[0], row[5]);
        if (measures[row[0]] != row[5] || row[13] == "fall" || row[13] == "non-finite") continue;
        if (std::stod(row[6]) > 1e-6) continue;
        std::array<char, 32> time{};
        std::snprintf(time.data(), time.size(), "%.2g ms", 1e3 * std::stod(row[9]));
        auto& best = cheapest.try_emplace(row[0], 1e9, "").first->second;
        if (std::stod(row[9]) < best.first)
            best = {std::stod(row[9]), row[1] + " (" + row[4] + "), " + time.data()};
    }
    REQUIRE(cheapest.size() == 2);
    for (const auto& [scene, best] : cheapest) {
        INFO(scene << ": " << best.second);
        CHECK(shown.find(best.second) != std::string::npos);
    }
}

}  // namespace

TEST_CASE("one command makes tables, plots and a page, and a second one the same errors and work") {
    const Folder folder;
    for (const char* out : {"a", "b"}) {
        const Ended ended =
            shell(folder, std::string("pushfactor report error --quick --only sphere_column,intersecting-stack "
                                      "--out ") +
                              out);
        INFO(ended.err);
        REQUIRE(ended.status == 0);
        CHECK(ended.out == std::string(out) + "/index.html\n");
    }
    const auto lines = without_times(folder.read("a/error.csv"));
    CHECK(lines == without_times(folder.read("b/error.csv")));
    CHECK(lines.front() == std::vector<std::string>{"scene", "method", "differs_from_preset", "knob", "value",
                                                    "error_measure", "error", "work_multiply_adds_per_simulated_s",
                                                    "outcome"});
    std::set<std::string> scenes;
    for (std::size_t i = 1; i < lines.size(); ++i) scenes.insert(lines[i][0]);
    CHECK(scenes == std::set<std::string>{"intersecting-stack", "sphere_column"});

    const std::string page = folder.read("a/index.html");
    check_page(page);
    for (const char* plot : {"error_sphere_column", "error_cpu_sphere_column", "error_intersecting_stack"}) {
        CHECK(page.find(std::string("<img src=\"") + plot + ".png\"") != std::string::npos);
        for (const char* ending : {".png", ".svg", ".dat"}) {
            CHECK(std::filesystem::file_size(folder / ("a/" + std::string(plot) + ending)) > 300);
        }
    }
    CHECK(folder.read("a/about.json").find("\"compiler\"") != std::string::npos);
    check_answers(folder.read("a/error.csv"), page);
}

TEST_CASE("the quick report makes everything", "[long]") {
    const Folder folder;
    const Ended ended = shell(folder, "pushfactor report error --quick --export problems --out .");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    for (const char* file :
         {"error.csv", "frozen.csv", "consistency.csv", "about.json", "index.html", "consistency.png",
          "frozen_stack_of_5_landing.png", "problems/frozen_stack_of_5_landing.json", "error_pendulum_wave.svg"}) {
        INFO(file);
        CHECK(std::filesystem::exists(folder / file));
    }
}

TEST_CASE("without gnuplot the report has its tables, and the page says what to install") {
    const Folder folder;
    const Ended ended = shell(folder, "PATH=/nowhere pushfactor report error --quick --only sphere_column --out .");
    INFO(ended.err);
    CHECK(ended.status == 0);
    std::filesystem::remove_all(folder / "pieces");
    CHECK(folder.files() == std::vector<std::string>{"about.json", "error.csv", "error_cpu_sphere_column.dat",
                                                     "error_sphere_column.dat", "index.html"});
    CHECK(folder.read("index.html").find("apt install gnuplot-nox") != std::string::npos);
}

TEST_CASE("an interrupted report ends with status 1 and leaves whole files only") {
    check_interrupted("error", "pieces/*/*/*.json");
}

TEST_CASE("reports refuse what they do not know in one line") {
    check_refused("report", "a report is missing: one of error, stability, cost, atlas");
    check_refused("report eror", "did you mean error?");
    check_refused("report error atlas", "report error atlas: must be one report at a time");
    check_refused("report error --only stak", "did you mean stack?");
    check_refused("report error --fast", "unknown option");
    check_refused("report error --problems x", "--problems: contact problems of FCLib are solved by tests/compare");
    CHECK(run_program("report error --quick --out /dev/null/x").status == 4);
}
