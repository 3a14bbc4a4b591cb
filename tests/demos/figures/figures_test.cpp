// The figures command: all files, numbers in the captions, with and without gnuplot.
#include "tests/catch.h"
#include "tests/demos/pages/check_page.h"
#include "tests/demos/program.h"

#include <regex>

using namespace pushfactor::tests;

namespace {

// The files that the page refers to.
// Files that the page shows or links to.
std::vector<std::string> references(const std::string& page) {
    std::vector<std::string> found;
    const std::regex reference("(?:src|href)=\"([^\"]*)\"");
    for (std::sregex_iterator i(page.begin(), page.end(), reference), end; i != end; ++i) {
        const std::string file = (*i)[1].str().substr(0, (*i)[1].str().find('#'));
        if (!file.empty()) found.push_back(file);
    }
    return found;
}

double number_after(const std::string& page, const std::string& words) {
    const auto at = page.find(words);
    REQUIRE(at != std::string::npos);
    return std::stod(page.substr(at + words.size()));
}

}  // namespace

TEST_CASE("one command makes all figures and a page that shows them from disk") {
    const Folder folder;
    const Ended ended = shell(folder, "pushfactor figures --out figures --width 400 --samples 1");
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    CHECK(ended.out == "figures/index.html\n");
    const std::string page = folder.read("figures/index.html");
    check_page(page);
    for (const std::string& name : references(page)) {
        INFO(name);
        CHECK(std::filesystem::file_size(folder / ("figures/" + name)) > 100);
    }
    for (const char* figure :
         {"figure_05", "figure_06", "figure_07", "figure_08", "figure_09", "figure_10", "figure_11",
          "push_against_beta", "push_pump", "intersecting_motion", "pendulum_energy", "stack_forces"}) {
        INFO(figure);
        CHECK(page.find(std::string("<img src=\"") + figure + ".png\"") != std::string::npos);
    }

    // The captions' numbers are measured; some are known in advance.
    CHECK(number_after(page, "it is at ") == Approx(10.8).margin(0.01));      // Figure 6, at rest
    CHECK(number_after(page, "fly upwards at ") == Approx(9.0).margin(0.1));  // Figure 7
}

TEST_CASE("without gnuplot the plots' data and all other figures are there, and the page says what to install") {
    const Folder folder;
    const Ended ended = shell(folder, "PATH=/nowhere pushfactor figures stack_forces --out . --width 400");
    INFO(ended.err);
    CHECK(ended.status == 0);
    CHECK(folder.files() == std::vector<std::string>{"index.html", "stack_forces.csv"});
    CHECK(folder.read("index.html").find("apt install gnuplot-nox") != std::string::npos);
    const std::string csv = folder.read("stack_forces.csv");
    CHECK(csv.starts_with("time_s,below_cube_1_n,"));
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 602);
}

TEST_CASE("a figure that is made again takes its place on the page, which keeps all others") {
    const Folder folder;
    for (const char* const name : {"figure_07", "figure_05", "figure_07"}) {
        require_success(folder, std::string("pushfactor figures --out . --width 400 --samples 1 ") + name);
    }
    const std::string page = folder.read("index.html");
    check_page(page);
    const std::size_t before = page.find("<img src=\"figure_05.png\""),
                      after = page.find("<img src=\"figure_07.png\"");
    CHECK(before < after);
    CHECK(after < page.size());
    CHECK(page.find("<img src=\"figure_07.png\"", after + 1) == std::string::npos);
}

TEST_CASE("a gnuplot that fails is an error with its own words") {
    const Folder folder;
    folder.write("gnuplot", "#!/bin/sh\necho 'line 3: undefined variable' >&2\nexit 1\n");
    std::filesystem::permissions(folder / "gnuplot", std::filesystem::perms::owner_all);
    const Ended ended = shell(folder, "PATH=.:$PATH pushfactor figures stack_forces --out plots --width 400");
    CHECK(ended.status == 4);
    CHECK(ended.err.find("gnuplot ended with status 1: line 3: undefined variable") != std::string::npos);
}

TEST_CASE("a figure that there is not is refused with the names of those that there are") {
    const Ended ended = run_program("figures figure_7");
    CHECK(ended.status == 2);
    CHECK(ended.err.find("figure figure_7: must be one of figure_05") != std::string::npos);
    CHECK(ended.err.find("did you mean figure_07?") != std::string::npos);
    CHECK(run_program("figures --width 10").status == 2);
}
