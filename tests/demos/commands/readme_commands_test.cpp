// The commands and links of all pages: the program accepts each command, and each link has a target. Nothing is
// run.
#include "demos/commands/command_line.h"
#include "demos/options/comparison.h"
#include "tests/catch.h"
#include "tests/demos/commands/markdown.h"
#include "tests/texts.h"

#include <algorithm>
#include <filesystem>
#include <variant>

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

// What commands find out only when they begin.
void understand(const auto&) {}
void understand(const demos::commands::Run& run) {
    demos::understand(run.scene, run.given);
}
void understand(const demos::commands::Scene& scene) {
    demos::understand(scene.scene, scene.given);
}
void understand(const demos::commands::Render& render) {
    for (const std::string& scene : render.scenes) demos::compared_runs(scene, render.given);
}

// Empty when the program accepts the command; with `values` off only its options are looked at, not what they say
// (N, NAME). Files of the pages do not exist: a scene file of the project stands for them.
std::string refusal(Words words, bool values) {
    const auto leave_out = [&words](const char* option) {
        const auto found = std::ranges::find(words, option);
        if (found == words.end() || found + 1 == words.end()) return false;
        words.erase(found, found + 2);
        return true;
    };
    if (leave_out("--config")) words.emplace_back("stack");
    leave_out("--measured");
    try {
        const auto entries = demos::command_entries();
        const auto entry =
            std::ranges::find(entries, words.empty() ? "" : words.front(), &demos::commands::Entry::name);
        if (!values && entry != entries.end()) {
            if (std::ranges::find(words, "--help") == words.end()) {
                demos::Words(entry->name, entry->options(), {words.begin() + 1, words.end()});
            }
            return "";
        }
        for (std::size_t i = 1; i < words.size(); ++i) {
            const bool is_scene = words[i].ends_with(".json") && !words[i - 1].starts_with("--");
            if (is_scene)
                words[i] = (root / (fs::exists(root / words[i]) ? words[i] : "assets/scenes/bridge.json")).string();
        }
        if (std::ranges::any_of(words,
                                [](const std::string& word) { return word == "--help" || word == "--version"; })) {
            return "";
        }
        const auto line = demos::parse_command_line(words);
        if (line) std::visit([](const auto& command) { understand(command); }, line->command);
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
    CHECK_THAT(refusal({"figures", "figure_99"}, true), Catch::Contains("figure_99"));
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
