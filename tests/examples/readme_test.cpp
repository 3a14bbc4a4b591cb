// The examples in the READMEs are the ones that are compiled and tested here.
#include "tests/catch.h"
#include "tests/examples/shown_examples.h"

using namespace pushfactor::tests;

namespace {

const std::string mark = "<!-- tests/examples/a.cpp: thing -->\n";
const std::string block = "```cpp\nint a;\n\nint b;\n```\n";
const std::string region = "// [example: thing]\nint a;\n\nint b;\n// [end]\n";

std::string faults_of(const std::string& page, const std::string& source) {
    std::string all;
    for (const std::string& fault :
         example_faults({{"engine/README.md", page}}, {{"tests/examples/a.cpp", source}})) {
        all += fault + "\n";
    }
    return all;
}

}  // namespace

TEST_CASE("every example of the READMEs is compiled, and every compiled example is in a README") {
    const Sources pages = sources_of({"engine", "renderer", "demos", "tests", "assets"}, {".md"});
    CHECK(pages.size() > 4);
    const Sources sources = sources_of({"tests/examples"}, {".cpp"});
    for (const std::string& fault : example_faults(pages, sources)) {
        INFO(fault);
        CHECK(fault.empty());
    }
}

TEST_CASE("an example that is shown as it is has no fault, other code than C++ needs no mark") {
    CHECK(faults_of("# A\n\n" + mark + block + "\n```\nint c;\n```\n", "#include <a>\n" + region).empty());
    CHECK(faults_of(mark + block + "and again\n" + mark + block, region).empty());
}

TEST_CASE("an example that differs in a byte from what is compiled is refused") {
    const std::string differs = "engine/README.md shows another tests/examples/a.cpp: thing than there is\n";
    CHECK(faults_of(mark + "```cpp\nint a;\n\nint b; \n```\n", region) == differs);
    CHECK(faults_of(mark + "```cpp\nint a;\nint b;\n```\n", region) == differs);
    CHECK(faults_of(mark + "```cpp\nint a;\n\nint b;\n\n```\n", region) == differs);
    CHECK(faults_of(mark + block, "// [example: thing]\nint a;\n\n// [end]\nint b;\n") == differs);
}

TEST_CASE("an example that nobody compiles, or that nobody shows, is refused") {
    const std::string unseen = "tests/examples/a.cpp: thing is shown nowhere\n";
    CHECK(faults_of("text\n", region) == unseen);
    CHECK(faults_of(block, region) == "engine/README.md shows C++ without saying whose\n" + unseen);
    CHECK(faults_of(mark + "\n" + block, region) ==
          "engine/README.md marks tests/examples/a.cpp: thing and does not show it\n"
          "engine/README.md shows C++ without saying whose\n" +
              unseen);
    CHECK(faults_of(mark, region) ==
          "engine/README.md marks tests/examples/a.cpp: thing and does not show it\n" + unseen);
    CHECK(faults_of(mark + block, "int a;\n\nint b;\n") ==
          "engine/README.md shows tests/examples/a.cpp: thing, which is not there\n");
}

TEST_CASE("regions and blocks that do not end, and regions of the same name, are refused") {
    CHECK(faults_of(mark + block, "// [example: thing]\nint a;\n\nint b;\n") ==
          "tests/examples/a.cpp: thing has no end\n");
    CHECK(faults_of(mark + block, "// [example: other]\n" + region) ==
          "tests/examples/a.cpp: other has no end\ntests/examples/a.cpp: other is shown nowhere\n");
    CHECK(faults_of(mark + block, region + "// [example: thing]\n// [end]\n") ==
          "tests/examples/a.cpp: thing is there twice\n");
    CHECK(faults_of(mark + "```cpp\nint a;\n", region) ==
          "engine/README.md has a block without an end\ntests/examples/a.cpp: thing is shown nowhere\n");
}
