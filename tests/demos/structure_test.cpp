// The include rules: which folder may include which.
#include "tests/catch.h"
#include "tests/texts.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>

using namespace pushfactor::tests;

namespace {

namespace fs = std::filesystem;

// The includes of a folder's sources.
std::set<std::string> included_by(const char* folder) {
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
    const auto found = included_by(folder);
    CHECK(found.size() > 5);
    for (const std::string& name : found) {
        INFO(folder << " includes " << name);
        CHECK(!begins_with_any(name, forbidden));
    }
}

// Which subfolders each subfolder includes.
using Includes = std::map<std::string, std::set<std::string>>;

// The subfolder of a file, or the file's name when it is in none.
std::string subfolder_of(const std::string& path) {
    const fs::path inside = fs::path(path.substr(path.find('/') + 1));
    return inside.has_parent_path() ? inside.begin()->string() : inside.stem().string();
}

// Which subfolders of a folder include which others.
Includes includes_within(const std::string& folder) {
    const std::regex include("#include \"(" + folder + "/[^\"]+)\"");
    Includes includes;
    for (const auto& [path, text] : sources_of({folder.c_str()}, {".h", ".cpp"})) {
        std::set<std::string>& included = includes[subfolder_of(path)];
        for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match) {
            const std::string subfolder = subfolder_of((*match)[1]);
            if (subfolder != subfolder_of(path) && subfolder != "commit")
                included.insert(subfolder);  // a file that the build writes
        }
    }
    return includes;
}

bool reaches(const Includes& all, const std::string& from, const std::string& to) {
    return std::any_of(all.at(from).begin(), all.at(from).end(),
                       [&](const std::string& next) { return next == to || reaches(all, next, to); });
}

// "a --> b" for what a includes but not through another subfolder. There must be no cycle.
std::set<std::string> arrows_of(const Includes& all) {
    std::set<std::string> arrows;
    for (const auto& [from, included] : all) {
        for (const std::string& to : included) {
            const bool follows = std::any_of(included.begin(), included.end(), [&](const std::string& other) {
                return other != to && reaches(all, other, to);
            });
            if (!follows) arrows.insert(from + " --> " + to);
        }
    }
    return arrows;
}

// The matches in the page about a folder, in order.
std::vector<std::string> shown(const std::string& folder, const std::regex& pattern) {
    const char* const page = folder == "demos" ? "EXTENDING.md" : "README.md";
    const std::string text = read_file(fs::path(PUSHFACTOR_SOURCE_DIR) / folder / page);
    std::vector<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
        found.push_back((*match)[1]);
    }
    return found;
}

}  // namespace

TEST_CASE(
    "every folder includes only folders above it in the table of its page, whose diagram shows the includes") {
    for (const std::string folder : {"engine", "renderer", "demos"}) {
        const Includes all = includes_within(folder);
        const std::vector<std::string> table = shown(folder, std::regex(R"(\n\| `(\w+)/`)"));
        CHECK(table.size() > 5);
        CHECK(table.size() <= 11);
        const auto place = [&](const std::string& subfolder) {
            return std::find(table.begin(), table.end(), subfolder) - table.begin();
        };
        std::size_t pairs = 0;  // of folders, of which the first includes the second
        for (const auto& [subfolder, included] : all) {
            if (place(subfolder) < std::ssize(table)) pairs += included.size();
            const fs::path path = fs::path(PUSHFACTOR_SOURCE_DIR) / folder / subfolder;
            INFO(folder << "/" << subfolder);
            if (fs::is_directory(path)) REQUIRE(place(subfolder) < std::ssize(table));
            for (const std::string& other : included) {
                INFO("includes " << other);
                REQUIRE((place(other) < place(subfolder) || place(subfolder) == std::ssize(table)));
            }
        }
        if (folder == "demos") CHECK(pairs <= 33);  // what has to be known to move anything in the program
        const std::vector<std::string> drawn = shown(folder, std::regex(R"(\n    (\w+ --> \w+))"));
        CHECK(std::set<std::string>(drawn.begin(), drawn.end()) == arrows_of(all));
    }
}

TEST_CASE("no folder has more than some fifteen sources, and only main.cpp is beside the folders of demos") {
    std::map<std::string, std::set<std::string>> sources;
    for (const auto& [path, text] : sources_of({"engine", "renderer", "demos"}, {".h", ".cpp"})) {
        sources[fs::path(path).parent_path().string()].insert(fs::path(path).stem().string());
    }
    for (const auto& [folder, names] : sources) {
        INFO(folder);
        CHECK(names.size() <= 15);
    }
    CHECK(sources.at("demos") == std::set<std::string>{"main"});
}

TEST_CASE("the engine knows Eigen only: no graphics, no demos, no files, no printing") {
    check_absent("engine", {"renderer/", "demos/", "tests/", "GL/", "glm/", "stb", "fmt/", "nlohmann/", "CLI/",
                            "fstream", "iostream", "filesystem", "cstdio"});
}

TEST_CASE(
    "constants that decide physics are in one list of at most fifty, each with a reason, and the step has none") {
    const std::regex constant(R"((\w+) = [-+.\de*/ ]+[,;])");
    std::vector<std::string> names;
    std::string before;
    for (const std::string& line :
         lines_of(read_file(fs::path(PUSHFACTOR_SOURCE_DIR) / "engine/base/constants.h"))) {
        if (line.starts_with("inline constexpr")) {
            INFO(line);
            CHECK((before.starts_with("//") || line.find("  // ") != std::string::npos));
            for (std::sregex_iterator match(line.begin(), line.end(), constant), end; match != end; ++match) {
                names.push_back((*match)[1]);
            }
        }
        before = line;
    }
    INFO(names.size() << " constants");
    CHECK(names.size() > 40);
    CHECK(names.size() <= 50);
    const std::regex number(R"(constexpr (double|int|float) \w+)");
    for (const auto& [path, text] : sources_of({"engine/step"}, {".h", ".cpp"})) {
        INFO(path);
        CHECK(!std::regex_search(text, number));
    }
}

// The clock says whether threads get their cores; how many of them work changes no bit.
TEST_CASE("one file of the engine knows threads, their library and a clock") {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PUSHFACTOR_SOURCE_DIR) / "engine")) {
        if (!entry.is_regular_file()) continue;
        const std::string text = read_file(entry.path());
        for (const char* const word :
             {"<tbb/", "<thread>", "<mutex>", "<future>", "<execution>", "<chrono>", "<ctime>"}) {
            if (text.find(std::string("#include ") + word) != std::string::npos) {
                files.insert(entry.path().filename().string());
            }
        }
    }
    CHECK(files == std::set<std::string>{"threads.cpp"});
}

TEST_CASE("the renderer knows no physics, and needs no GL or X to be built") {
    check_absent("renderer", {"engine/", "demos/", "tests/", "Eigen", "GL/", "EGL/", "KHR/", "X11/"});
}

TEST_CASE("scenes know the engine and nothing that draws or writes") {
    check_absent("demos/scenes/named",
                 {"renderer/", "glm/", "GL/", "fstream", "iostream", "filesystem", "chrono", "fmt/"});
}

// Everything that a file of the project includes, directly or indirectly.
void gather(const std::string& file, std::set<std::string>& found) {
    const std::regex include(R"re(#include "([^"]+)")re");
    const std::string text = read_file(fs::path(PUSHFACTOR_SOURCE_DIR) / file);
    for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match) {
        if (found.insert((*match)[1]).second) gather((*match)[1], found);
    }
}

TEST_CASE("the pendulum wave includes no collision header, not even through another one") {
    std::set<std::string> wave, stack;
    gather("demos/scenes/named/pendulum_wave.cpp", wave);
    gather("demos/runs/build/build_scene.cpp", stack);
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
