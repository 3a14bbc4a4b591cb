// Judges random scenes, or the scene files that it is given. Exit status: 0 all hold, 1 interrupted, 2 wrong usage,
// 3 some fail, 4 a failure could not be written.
#include "demos/errors.h"
#include "demos/output_file.h"
#include "demos/progress.h"
#include "demos/scene_file.h"
#include "tests/fuzz/campaign.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

using namespace pushfactor;
using namespace pushfactor::tests;

namespace {

struct Options {
    long scenes = 10000;
    std::uint64_t seed = 1;
    std::filesystem::path out = "out/fuzz";
    std::vector<std::filesystem::path> files;
};

void report(const Failure& failure, const std::filesystem::path& folder) {
    demos::make_folder(folder);
    const std::filesystem::path file = folder / (failure.scene.name + ".json");
    demos::write_file(file, demos::scene_file_text(failure.scene));
    fmt::print("seed {}: {} fails in step {}: {}\n  {}\n", failure.seed, failure.verdict.claim,
               failure.verdict.step, failure.verdict.what, file.string());
}

bool is_interrupted() {
    try {
        demos::stop_if_interrupted("");
    } catch (const demos::RunError&) {
        return true;
    }
    return false;
}

Campaign watched_campaign(const Options& options) {
    demos::note_interrupts();
    demos::ProgressBar bar("scenes", options.scenes);
    return judge_scenes(options.seed, options.scenes, [&](long done) {
        bar.show(done);
        return !is_interrupted();
    });
}

int fuzz(const Options& options) {
    const Campaign campaign = watched_campaign(options);
    for (const Failure& failure : campaign.failures) report(failure, options.out);
    fmt::print("{} scenes: {} hold, {} became non-finite, {} fail\n", campaign.judged,
               campaign.judged - campaign.non_finite - static_cast<long>(campaign.failures.size()),
               campaign.non_finite, campaign.failures.size());
    if (!campaign.failures.empty()) return demos::check_failed;
    return campaign.judged < options.scenes ? demos::run_failed : demos::done;
}

bool holds(const std::filesystem::path& file) {
    const Verdict verdict = judge(demos::read_scene_file(file));
    const std::string text =
        verdict.kind == Verdict::Kind::holds
            ? "holds"
            : fmt::format("{} fails in step {}: {}", verdict.claim, verdict.step, verdict.what);
    fmt::print("{}: {}\n", file.string(), text);
    return verdict.kind != Verdict::Kind::fails;
}

int run(const Options& options) {
    try {
        if (options.files.empty()) return fuzz(options);
        const auto failing = std::count_if(options.files.begin(), options.files.end(),
                                           [](const auto& file) { return !holds(file); });
        return failing == 0 ? demos::done : demos::check_failed;
    } catch (const demos::UsageError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return demos::bad_usage;
    } catch (const demos::OutputError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return demos::output_failed;
    }
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Judges random scenes: finite, forces within bounds, momentum and energy kept. A scene that fails "
        "is shrunk and written as a scene file.");
    app.add_option("--scenes", options.scenes, "how many")
        ->check(CLI::Range(1L, 1'000'000'000L))
        ->capture_default_str();
    app.add_option("--seed", options.seed, "seed of the first; the next has the next")->capture_default_str();
    app.add_option("--out", options.out, "folder for scenes that fail")->capture_default_str();
    app.add_option("FILE", options.files, "scene files to judge instead");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? demos::done : demos::bad_usage;
    }
    return run(options);
}
