// Prints what has to be the same on every machine, with every compiler and in every build type: state hashes after
// one second and at the end of runs, and residuals and work of all solvers on systems of one step.
//   bits >tests/hashes/lines.txt           writes the list, after a change that is meant to alter them
//   bits --check tests/hashes/lines.txt    prints the lines that are others than those in a file; then exits with 1
//   --short                              stops runs after one second
//   WORD                                 only lines that contain it, such as a preset or a scene
#include "demos/base/platform/assets.h"
#include "demos/options/named_run.h"
#include "demos/runs/simulation.h"
#include "demos/scenes/scene_file.h"
#include "engine/bodies/diagnostics.h"
#include "engine/solvers/solver.h"
#include "tests/fuzz/members.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

using namespace pushfactor;
using namespace pushfactor::demos;

namespace {

namespace fs = std::filesystem;

struct Run {
    std::string scene;
    OptionTexts options;

    std::string text() const { return command_text("run", scene, options); }
};

// What the 600 steps of every scene below do not have: threads, other options, large scenes.
const std::vector<Run> further{
    {"stack", {{"seconds", "20"}, {"jitter", "0.01"}, {"seed", "3"}}},
    {"stack", {{"seconds", "5"}, {"rotation", "exponential"}, {"friction-model", "coulomb"}}},
    {"funnel", {{"count", "400"}, {"seconds", "2"}, {"threads", "2"}}},
    {"pendulum-grid", {{"seconds", "2"}, {"poke", "60"}, {"poke-at", "0.5"}}},
    {"chain", {{"seconds", "2"}, {"substeps", "4"}}},
    {"chain", {{"seconds", "2"}, {"scheme", "rattle4"}}},
    {"chain", {{"seconds", "8"}, {"end-mass", "1000"}, {"substeps", "auto"}}},
};

// Solvers get the system of a whole step; the paper's bound of friction makes the problem convex.
const std::vector<Run> moments{
    {"stack",
     {{"gap", "0.1"}, {"jitter", "0.01"}, {"seconds", "0.32"}, {"friction-model", "paper"}, {"scheme", "whole"}}},
    {"funnel", {{"count", "20"}, {"seconds", "5"}, {"friction-model", "paper"}, {"scheme", "whole"}}},
    {"pendulum-grid", {{"seconds", "1"}, {"friction-model", "paper"}, {"scheme", "whole"}}},
    {"chain", {{"end-mass", "1000"}, {"substeps", "32"}, {"seconds", "1"}, {"scheme", "whole"}}},
    {"sphere_column", {{"seconds", "0.02"}, {"scheme", "whole"}}},
};

constexpr long short_run = 60;  // steps

// The hash after the first steps, and at the end: "-" if it is not run.
std::string hashes_of(const Run& run, bool in_short) {
    Simulation simulation(run_of(run.scene, run.options));
    const auto hash = [&] { return fmt::format("{:016x}", engine::state_hash(simulation.scene().world.bodies)); };
    const long steps = whole_steps(simulation.settings());
    std::string first;
    for (long step = 1; step <= steps; ++step) {
        simulation.advance();
        if (step != short_run) continue;
        first = hash();
        if (in_short) return first + " -";
    }
    return first + " " + hash();
}

std::vector<std::string> solutions_of(const Run& run) {
    Simulation simulation(run_of(run.scene, run.options));
    const long steps = std::max(1L, whole_steps(simulation.settings()));
    for (long step = 0; step < steps; ++step) simulation.advance();
    const engine::SystemEquation& system = simulation.scene().world.system();
    std::vector<std::string> lines;
    for (const engine::solvers::SolverEntry& entry : engine::solvers::solver_table()) {
        for (const int iterations : {1, 5, 25, 100}) {
            engine::Columns lambda = engine::Columns::Zero(system.row_count(), system.column_count());
            const auto count = entry.make()->solve(
                system, {.iterations = iterations, .tolerance_high = 0.0, .tolerance_low = 0.0}, lambda);
            lines.push_back(fmt::format("{:a} {:a}  {}, {} iterations of {}", natural_residual(system, lambda),
                                        count.multiply_adds, run.scene, iterations, entry.name));
        }
    }
    return lines;
}

std::vector<std::string> scene_files() {
    std::vector<std::string> names;
    for (const fs::directory_entry& file : fs::directory_iterator(asset_folder("scenes"))) {
        if (file.path().extension() != ".json" || file.path().stem().has_extension()) continue;  // not the schema
        names.push_back(file.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

class Lines {
  public:
    struct Wish {
        std::string word;       // which they contain
        bool in_short = false;  // only the first steps
        std::optional<std::string> file{};
    };

    explicit Lines(const Wish& wish) : wish_(wish) {
        if (!wish.file) return;
        std::ifstream stream(*wish.file);
        for (std::string line; std::getline(stream, line);) expected_.emplace(text_of(line), line);
        if (expected_.empty()) throw std::runtime_error(*wish.file + ": has no lines");
    }

    // Every scene, every file, and a member of every family.
    void run_all(const std::string& preset) {
        const OptionTexts options{{"preset", preset}, {"dt", "1/60"}, {"seconds", "10"}};
        for (const SceneEntry& entry : catalogue()) run({std::string(entry.name), options});
        for (const std::string& name : scene_files()) run({name, options});
        for (const families::Family& family : families::families()) {
            const families::Member member = tests::draw_bounded_member(family, {.small = true});
            const std::string text = member.command() + " >f.json; " + Run{"f.json", options}.text();
            if (!is_wanted(text)) continue;
            const fs::path file = fs::temp_directory_path() / fmt::format("{}.{}.json", family.name, preset);
            std::ofstream(file) << scene_file_text(member.prospect.scene);
            give(hashes_of({file.string(), options}, wish_.in_short) + "  " + text);
            fs::remove(file);
        }
    }

    void run(const Run& run) {
        if (is_wanted(run.text())) give(hashes_of(run, wish_.in_short) + "  " + run.text());
    }

    void solve(const Run& run) {
        if (!is_wanted(run.text())) return;
        for (const std::string& line : solutions_of(run)) give(line);
    }

    bool are_as_expected() const { return others_ == 0; }
    int count() const { return count_; }

  private:
    bool is_wanted(const std::string& text) const { return text.find(wish_.word) != std::string::npos; }

    // What follows the two numbers.
    static std::string text_of(const std::string& line) {
        return line.substr(std::min(line.size(), line.find("  ")));
    }

    void give(const std::string& line) {
        ++count_;
        if (!wish_.file) {
            fmt::print("{}\n", line);
        } else {
            const auto found = expected_.find(text_of(line));
            const std::string expected = found == expected_.end() ? "no such line" : found->second;
            const std::size_t compared = wish_.in_short ? line.find(' ') : line.size();
            if (expected.substr(0, compared) != line.substr(0, compared)) {
                ++others_;
                fmt::print("here      {}\nexpected  {}\n", line, expected);
            }
        }
        std::fflush(stdout);
    }

    Wish wish_;
    std::map<std::string, std::string> expected_;  // by their texts
    int count_ = 0, others_ = 0;
};

Lines::Wish wish_of(std::span<char* const> words) {
    Lines::Wish wish;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string word = words[i];
        if (word == "--short") {
            wish.in_short = true;
        } else if (word == "--check" && i + 1 < words.size()) {
            wish.file = words[++i];
        } else {
            wish.word = word;
        }
    }
    return wish;
}

}  // namespace

int main(int count, char** words) {
    try {
        Lines lines(wish_of({words + 1, words + count}));
        for (const char* const preset : {"paper", "default", "exact"}) lines.run_all(preset);
        for (const Run& run : further) lines.run(run);
        for (const Run& run : moments) lines.solve(run);
        fmt::print(stderr, "{} lines\n", lines.count());
        return lines.are_as_expected() ? 0 : 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "bits: {}\n", error.what());
        return 2;
    }
}
