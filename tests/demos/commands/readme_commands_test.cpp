// The commands and links of all pages: the program accepts each command, and each link has a target. Nothing is
// run.
#include "demos/commands/command_line.h"
#include "demos/figures/figure.h"
#include "demos/options/comparison.h"
#include "demos/scenes/families/family.h"
#include "demos/text/errors.h"
#include "tests/catch.h"
#include "tests/demos/commands/markdown.h"
#include "tests/texts.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>

using namespace pushfactor;
using namespace pushfactor::tests;
using Words = std::vector<std::string>;

namespace {

namespace fs = std::filesystem;

const fs::path root(PUSHFACTOR_SOURCE_DIR);

// Path within the repository -> text of every page, without build trees and outputs.
Sources pages() {
    Sources found;
    for (auto at = fs::recursive_directory_iterator(root); at != fs::end(at); ++at) {
        const std::string name = at->path().filename().string();
        if (at->is_directory() && (name == "build" || name == "out" || name.starts_with('.'))) {
            at.disable_recursion_pending();
        } else if (name.ends_with(".md")) {
            found[fs::relative(at->path(), root).generic_string()] = read_file(at->path());
        }
    }
    return found;
}

bool is_scene(const std::string& name) {
    const auto scenes = demos::catalogue();
    return std::ranges::any_of(scenes, [&](const demos::SceneEntry& entry) { return entry.name == name; });
}

// The program's objections to the scenes, options and names of a command. Scenes that are neither in the catalogue
// nor in the repository (SCENE, my.json) are left out, and with `values` off the values of options (N, NAME).
void understand(const demos::Request& request, bool values) {
    for (const std::string& name : request.families) {
        if (!demos::families::find_family(name) && values) throw demos::UsageError("family " + name);
    }
    for (const std::string& name : request.figures) {
        const auto figures = demos::figures::all_figures();
        if (std::ranges::none_of(figures, [&](const demos::figures::Figure& f) { return f.name == name; })) {
            throw demos::UsageError("figure " + name);
        }
    }
    for (const std::string& scene : request.scenes) {
        const bool file = scene.find('/') != std::string::npos && fs::exists(root / scene);
        if (values && (file || is_scene(scene))) {
            demos::compared_runs(file ? (root / scene).string() : scene, request.given);
        }
    }
}

// Keeps the output of --help out of the tests' output.
class Silence {
  public:
    Silence() : before_(std::cout.rdbuf(text_.rdbuf())) {}
    ~Silence() { std::cout.rdbuf(before_); }
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;

  private:
    std::ostringstream text_;
    std::streambuf* before_;
};

// Empty when the program accepts the command.
std::string refusal(const Words& words, bool values) {
    Words with_program = words;
    with_program.insert(with_program.begin(), "pushfactor");
    // A configuration file that a run writes does not exist yet.
    const auto config = std::ranges::find(with_program, "--config");
    if (config != with_program.end() && config + 1 != with_program.end()) {
        with_program.erase(config, config + 2);
        with_program.push_back("stack");
    }
    std::vector<char*> arguments;
    for (std::string& word : with_program) arguments.push_back(word.data());
    const Silence silence;
    try {
        const auto request = demos::parse_command_line(static_cast<int>(arguments.size()), arguments.data());
        if (request) understand(*request, values);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

std::string joined(const Words& words) {
    std::string line = "pushfactor";
    for (const std::string& word : words) line += " " + word;
    return line;
}

}  // namespace

TEST_CASE("every command in a code block of a README is one that the program accepts, down to its values") {
    std::size_t count = 0;
    for (const auto& [path, page] : pages()) {
        for (const Words& words : commands_of(page, false)) {
            INFO(path << ": " << joined(words));
            CHECK(refusal(words, true) == "");
            ++count;
        }
    }
    CHECK(count > 30);
}

TEST_CASE("every command in a sentence of a README has options that the program knows") {
    std::size_t count = 0;
    for (const auto& [path, page] : pages()) {
        for (const Words& words : commands_of(page, true)) {
            INFO(path << ": " << joined(words));
            CHECK(refusal(words, false) == "");
            ++count;
        }
    }
    CHECK(count > 60);
}

TEST_CASE("every relative link of a README leads to a file, and to a heading where it names one") {
    std::size_t count = 0;
    for (const auto& [path, page] : pages()) {
        for (const std::string& fault : link_faults(root.string(), path, page)) {
            INFO(fault);
            CHECK(fault.empty());
        }
        count += links_of(page).size();
    }
    CHECK(count > 40);
}

TEST_CASE("commands are found in code blocks, and refused when the program does not know them") {
    const std::string page =
        "# A\n\n```\npushfactor run stack --sede 3  # not --seed\n  - run: build/release/pushfactor list > a.txt\n"
        "pushfactor run stack \\\n    --dt 2/0\n```\n\n    pushfactor rum stack\n\nand `pushfactor run\nstack "
        "--foo`.\n";
    const std::vector<Words> commands = commands_of(page, false);
    CHECK(commands ==
          std::vector<Words>{
              {"run", "stack", "--sede", "3"}, {"list"}, {"run", "stack", "--dt", "2/0"}, {"rum", "stack"}});
    CHECK_THAT(refusal(commands[0], false), Catch::Contains("did you mean --seed?"));
    CHECK(refusal(commands[1], true) == "");
    CHECK(refusal(commands[2], false) == "");
    CHECK_THAT(refusal(commands[2], true), Catch::Contains("--dt 2/0"));
    CHECK_THAT(refusal(commands[3], false), Catch::Contains("did you mean run?"));
    CHECK(commands_of(page, true).back() == Words{"run", "stack", "--foo"});
    CHECK_THAT(refusal(commands_of(page, true).back(), false), Catch::Contains("--foo"));
    CHECK_THAT(refusal({"figures", "figure_99"}, false), Catch::Contains("figure_99"));
    CHECK_THAT(refusal({"render", "assets/scenes/bridge.json", "--overlay", "x"}, true),
               Catch::Contains("--overlay"));
}

TEST_CASE("links are found outside of code, and refused when nothing is there") {
    const std::string page =
        "# Two words, `x`\n[a](README.md) ![b](no/such.png) `[c](d.md)`\n[e](#two-words-x) [f](#three) "
        "[g](https://h.example/i) [j](demos/README.md#nowhere)\n\n```\n[k](l.md)\n```\n# Two words, x\n";
    CHECK(links_of(page) == Words{"README.md", "no/such.png", "#two-words-x", "#three", "demos/README.md#nowhere"});
    CHECK(link_faults(root.string(), "PAGE.md", page) == Words{"PAGE.md: no/such.png is not there",
                                                               "PAGE.md: no heading is #three",
                                                               "PAGE.md: no heading is demos/README.md#nowhere"});
    CHECK(anchors_of("# A b\n## The paper's map: 3.1\n# A b\n") ==
          std::set<std::string>{"a-b", "a-b-1", "the-papers-map-31"});
}
