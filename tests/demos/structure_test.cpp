// The shape of the house: which folder may include which.
#include "tests/catch.h"
#include "tests/texts.h"

#include <map>
#include <regex>
#include <set>

using namespace pushfactor::tests;

namespace {

namespace fs = std::filesystem;

// What the sources of a folder include.
std::set<std::string> includes(const char* folder) {
    std::set<std::string> found;
    const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
    for (const auto& [path, text] : sources_of({folder}, {".h", ".cpp"})) {
        for (const std::string& line : lines_of(text)) {
            std::smatch match;
            if (std::regex_search(line, match, include)) found.insert(match[1]);
        }
    }
    return found;
}

bool begins_with_any(const std::string& text, std::initializer_list<std::string_view> prefixes) {
    return std::any_of(prefixes.begin(), prefixes.end(), [&](std::string_view p) { return text.starts_with(p); });
}

void check_absent(const char* folder, std::initializer_list<std::string_view> forbidden) {
    const auto found = includes(folder);
    CHECK(found.size() > 5);
    for (const std::string& name : found) {
        INFO(folder << " includes " << name);
        CHECK(!begins_with_any(name, forbidden));
    }
}

}  // namespace

TEST_CASE("the engine knows Eigen only: no graphics, no demos, no files, no clock, no printing") {
    check_absent("engine", {"renderer/", "demos/", "tests/", "GL/", "glm/", "stb", "fmt/", "nlohmann/", "CLI/",
                            "fstream", "iostream", "filesystem", "chrono", "ctime", "cstdio"});
}

TEST_CASE("one file of the engine knows threads and their library") {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PUSHFACTOR_SOURCE_DIR) / "engine")) {
        if (!entry.is_regular_file()) continue;
        const std::string text = read_file(entry.path());
        for (const char* const word : {"<tbb/", "<thread>", "<mutex>", "<future>", "<execution>"}) {
            if (text.find(std::string("#include ") + word) != std::string::npos) {
                files.insert(entry.path().filename().string());
            }
        }
    }
    CHECK(files == std::set<std::string>{"threads.cpp"});
}

TEST_CASE("the renderer knows no physics") {
    check_absent("renderer", {"engine/", "demos/", "tests/", "Eigen"});
}

TEST_CASE("scenes know the engine and nothing that draws or writes") {
    check_absent("demos/scenes",
                 {"renderer/", "glm/", "GL/", "fstream", "iostream", "filesystem", "chrono", "fmt/"});
}

// Everything that a file of the project includes, directly or not.
void gather(const std::string& file, std::set<std::string>& found) {
    const std::regex include(R"re(#include "([^"]+)")re");
    const std::string text = read_file(fs::path(PUSHFACTOR_SOURCE_DIR) / file);
    for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match) {
        if (found.insert((*match)[1]).second) gather((*match)[1], found);
    }
}

TEST_CASE("the pendulum wave includes no collision header, not even through another one") {
    std::set<std::string> wave, stack;
    gather("demos/scenes/pendulum_wave.cpp", wave);
    gather("demos/build_scene.cpp", stack);
    const auto of_contacts = [](const std::string& name) {
        return name.find("collision") != std::string::npos || name.find("contact") != std::string::npos;
    };
    CHECK(std::none_of(wave.begin(), wave.end(), of_contacts));
    CHECK(std::any_of(stack.begin(), stack.end(), of_contacts));  // the test can fail
    CHECK(wave.size() > 5);
}

TEST_CASE("Eigen becomes GLM in one file only") {
    const auto glm = std::regex(R"(#include\s*<glm/)");
    std::set<std::string> files;
    for (const auto& [path, text] : sources_of({"demos"}, {".h", ".cpp"})) {
        if (std::regex_search(text, glm)) files.insert(fs::path(path).stem().string());
    }
    CHECK(files == std::set<std::string>{"to_glm"});
}
