// The map of the paper and its errata against the repository itself.
#include "tests/engine/paper/paper_map.h"

#include "tests/catch.h"

#include <filesystem>

using namespace pushfactor::tests;

namespace {

namespace fs = std::filesystem;

// Every equation that has a number in the paper; 12.3.3 is cited in section 9.2 and is in section 12.3.1. Every
// figure.
std::vector<std::string> places_of_the_paper() {
    std::vector<std::string> places{
        "(3.2.1)", "(3.2.2)", "(3.2.3)",  "(3.2.4)",  "(5.1.1)",  "(5.1.2)",  "(5.1.3)",  "(5.2.1)",  "(5.2.2)",
        "(5.2.3)", "(5.3.1)", "(6.1.1)",  "(6.1.2)",  "(6.1.3)",  "(6.1.4)",  "(6.1.5)",  "(6.1.6)",  "(6.1.7)",
        "(6.2.1)", "(6.2.2)", "(6.2.3)",  "(6.2.4)",  "(6.2.5)",  "(6.2.6)",  "(6.2.7)",  "(6.2.8)",  "(6.2.9)",
        "(7.1.1)", "(8.2.1)", "(12.2.1)", "(12.2.2)", "(12.3.1)", "(12.3.2)", "(12.3.3)", "(12.4.1)", "(12.5.1)"};
    for (int figure = 1; figure <= 11; ++figure) places.push_back("Figure " + std::to_string(figure));
    return places;
}

const Sources small{{"engine/a.h", "struct Thing {};\nvoid solve();  // no other\n"},
                    {"tests/a_test.cpp",
                     "TEST_CASE(\"a claim\") {}\nTEMPLATE_TEST_CASE(\n    \"a \\\"long\\\" "
                     "|claim| \"\n    \"in two\", \"[tag]\", int) {}\n"},
                    {"engine/not_a_test.cpp", "TEST_CASE(\"of no test\")"}};

const std::string one_erratum = "### 1. A sign\n\nIt is minus.\n\nTest: `a claim`\n";
const std::string good_line =
    "| (1.2.3) | says | `engine/a.h`: `Thing`, `solve` | `a claim` | corrected, see erratum 1 |";

std::string map_of(const std::string& line) {
    return "# A\n\n| not | this |\n\n# The paper map\n\ntext\n\n| paper | says | where | test | status |\n"
           "|---|---|---|---|---|\n" +
           line + "\n\n# After it\n\n| nor | this |\n| a | b |\n| c | d |\n";
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    return text.replace(text.find(what), what.size(), with);
}

// The faults of a map of one line, and of one erratum.
std::string faults_of(const std::string& line, const std::string& errata = one_erratum) {
    const std::vector<std::string> wanted{"(1.2.3)"};
    std::string all;
    for (const std::string& fault : map_faults(map_of(line), errata, small, wanted)) all += fault + "\n";
    return all;
}
std::string faults_with(const std::string& what, const std::string& with) {
    return faults_of(replaced(good_line, what, with));
}

}  // namespace

TEST_CASE("every equation, figure and claim of the paper is in the map, with living code and a living test") {
    const fs::path engine = fs::path(PUSHFACTOR_SOURCE_DIR) / "engine";
    const std::string map = read_file(engine / "PAPER.md");
    const Sources sources = sources_of({"engine", "renderer", "demos", "tests", "assets"}, {".h", ".cpp", ".json"});
    CHECK(map_entries(map).size() > 100);
    for (const std::string& fault :
         map_faults(map, read_file(engine / "ERRATA.md"), sources, places_of_the_paper())) {
        INFO(fault);
        CHECK(fault.empty());
    }
}

TEST_CASE("test names are read as the compiler reads them, from tests alone") {
    CHECK(test_names(small) == std::set<std::string>{"a claim", "a \"long\" |claim| in two"});
}

TEST_CASE("a map that is true has no faults") {
    CHECK(faults_of(good_line).empty());
    CHECK(faults_with("`a claim`", "`a claim`; `a \"long\" \\|claim\\| in two`").empty());
    CHECK(map_entries(map_of(good_line)).size() == 1);
}

TEST_CASE("a map that names dead code or a dead test is refused") {
    CHECK(faults_with("engine/a.h", "engine/b.h") ==
          "(1.2.3): there is no file engine/b.h\n(1.2.3): there is no Thing in engine/b.h\n"
          "(1.2.3): there is no solve in engine/b.h\n");
    CHECK(faults_with("`solve`", "`solv`") == "(1.2.3): there is no solv in engine/a.h\n");
    CHECK(faults_with("`solve`", "`other`") == "(1.2.3): there is no other in engine/a.h\n");  // in a comment
    CHECK(faults_with(": `Thing`, `solve`", "") ==
          "(1.2.3): engine/a.h has no name in it\n(1.2.3): has no function or type\n");
    CHECK(faults_with("`engine/a.h`: `Thing`, `solve`", "") == "(1.2.3): has no function or type\n");
    CHECK(faults_with("`a claim`", "") == "(1.2.3): has no test\n");
    CHECK(faults_with("`a claim`", "none, because nobody knows") == "(1.2.3): has no test\n");
    CHECK(faults_with("`a claim`", "`a clai`") == "(1.2.3): there is no test \"a clai\"\n");
    CHECK(faults_with("`a claim`", "`of no test`") == "(1.2.3): there is no test \"of no test\"\n");
    CHECK(
        faults_with("| says ", "") ==
        "| (1.2.3) | `engine/a.h`: `Thing`, `solve` | `a claim` | corrected, see erratum 1 |: has not five cells\n"
        "erratum 1: is not cited in the map\n");
}

TEST_CASE("a map without an equation, or with a status that says nothing, is refused") {
    CHECK(faults_with("(1.2.3)", "(1.2.4)") == "(1.2.3): is not in the map\n");
    CHECK(faults_with("(1.2.3)", "(11.2.3)") == "(1.2.3): is not in the map\n");
    const auto figure = [](const std::string& place) {
        const std::vector<std::string> wanted{"Figure 1"};
        return map_faults(map_of(replaced(good_line, "(1.2.3)", place)), one_erratum, small, wanted).size();
    };
    CHECK(figure("Figure 1") == 0);
    CHECK(figure("Figure 11") == 1);
    CHECK(faults_with("corrected, see erratum 1", "done, see erratum 1") ==
          "(1.2.3): status \"done, see erratum 1\" is none of the three\n");
    CHECK(faults_with("see erratum 1", "see erratum 1, 2 and 10") ==
          "(1.2.3): there is no erratum 2\n(1.2.3): there is no erratum 10\n");
    CHECK(faults_with("see erratum 1", "somehow") ==
          "(1.2.3): is corrected by no erratum\nerratum 1: is not cited in the map\n");
}

TEST_CASE("what is not used needs no code, but a reason, and a test or the reason why there is none") {
    const std::string unused = "| (1.2.3) | says | | `a claim` | not used, because it is wrong, see erratum 1 |";
    CHECK(faults_of(unused).empty());
    CHECK(faults_of(replaced(unused, "`a claim`", "none, because it is a remark")).empty());
    CHECK(faults_of(replaced(unused, "`a claim`", "")) ==
          "(1.2.3): has neither a test nor a reason why there is none\n");
    CHECK(faults_of(replaced(unused, ", because it is wrong", "")) ==
          "(1.2.3): has no function or type\n(1.2.3): status \"not used, see erratum 1\" is none of the three\n");
}

TEST_CASE("errata are numbered, each has a test, and each is cited") {
    CHECK(faults_of(good_line, replaced(one_erratum, "Test: ", "Seen: ")) == "erratum 1: has no test\n");
    CHECK(faults_of(good_line, replaced(one_erratum, "a claim", "a clam")) ==
          "erratum 1: there is no test \"a clam\"\n");
    CHECK(faults_of(good_line, one_erratum + replaced(one_erratum, "1", "2")) ==
          "erratum 2: is not cited in the map\n");
    CHECK(faults_of(good_line, replaced(one_erratum, "1", "2")) ==
          "(1.2.3): there is no erratum 1\nerratum 2: is out of order\nerratum 2: is not cited in the map\n");
}
