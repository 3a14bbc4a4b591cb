// Judges random scenes, members of the families, what sleeps in them, pairs that pass or touch, falls of thin
// bodies, or given scene files. Exit status: 0 all hold, 1 interrupted, 2 wrong usage, 3 some fail, 4 a failure
// could not be written.
#include "demos/base/platform/output_file.h"
#include "demos/base/platform/progress.h"
#include "demos/base/text/errors.h"
#include "demos/scenes/scene_file.h"
#include "tests/fuzz/campaign.h"
#include "tests/fuzz/family_campaign.h"
#include "tests/fuzz/family_page.h"
#include "tests/fuzz/meeting_campaign.h"
#include "tests/fuzz/sleepers.h"
#include "tests/fuzz/thin_falls.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

using namespace pushfactor;
using namespace pushfactor::tests;

namespace {

struct OptionTexts {
    long scenes = 10000;
    std::uint64_t seed = 1;
    std::filesystem::path out = "out/fuzz";
    std::vector<std::filesystem::path> files;
    FamilyRequest families;
    bool page = false;
    long meetings = 0, thin_falls = 0, sleepers = 0;
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

// judge(go_on), with a bar that shows how many of `count` are done, until Ctrl-C.
template <typename Judge>
auto watched(const char* what, long count, const Judge& judge) {
    demos::note_interrupts();
    demos::ProgressBar bar(what, count);
    return judge([&](long done) {
        bar.show(done);
        return !is_interrupted();
    });
}

// Calls `report` for each that does not hold, prints the table, and returns the exit status.
template <typename Judged, typename Report>
int conclude(const std::vector<Judged>& judged, long wanted, const std::string& table, const Report& report) {
    const bool all_hold = std::all_of(judged.begin(), judged.end(), [](const Judged& one) { return one.holds(); });
    for (const Judged& one : judged) {
        if (!one.holds()) report(one);
    }
    fmt::print("{}", table);
    if (!all_hold) return demos::check_failed;
    return static_cast<long>(judged.size()) < wanted ? demos::run_failed : demos::done;
}

int fuzz(const OptionTexts& options) {
    const Campaign campaign = watched("scenes", options.scenes, [&](const GoOn& go_on) {
        return judge_scenes(options.seed, options.scenes, go_on);
    });
    for (const Failure& failure : campaign.failures) report(failure, options.out);
    fmt::print("{} scenes: {} hold, {} became non-finite, {} fail\n", campaign.judged,
               campaign.judged - campaign.non_finite - static_cast<long>(campaign.failures.size()),
               campaign.non_finite, campaign.failures.size());
    if (!campaign.failures.empty()) return demos::check_failed;
    return campaign.judged < options.scenes ? demos::run_failed : demos::done;
}

void report(const JudgedMember& judged, const OptionTexts& options) {
    demos::make_folder(options.out);
    const demos::SceneDescription scene = as_judged(judged.member, options.families.preset);
    const std::filesystem::path file = options.out / (scene.name + ".json");
    demos::write_file(file, demos::scene_file_text(scene));
    fmt::print("{}: {}\n  {}\n", scene.name, failures_of(judged.judgement), judged.member.command());
}

int judge_families(const OptionTexts& options) {
    const FamilyRequest& request = options.families;
    if (!request.only.empty() && !demos::families::find_family(request.only)) {
        throw demos::UsageError(
            fmt::format("--family {}: must be a family (see `pushfactor family`)", request.only));
    }
    const std::vector<JudgedMember> judged =
        watched("members", request.members, [&](const GoOn& go_on) { return judge_members(request, go_on); });
    const int status = conclude(judged, request.members, family_table(judged),
                                [&](const JudgedMember& one) { report(one, options); });
    if (options.page) write_family_page(judged, request, options.out);
    return status;
}

void report(const JudgedMeeting& judged, const std::filesystem::path& folder) {
    demos::make_folder(folder);
    demos::SceneDescription scene = judged.meeting.scene;
    scene.options["preset"] = judged.preset;
    const std::filesystem::path file = folder / (scene.name + ".json");
    demos::write_file(file, demos::scene_file_text(scene));
    fmt::print("{}, {:.3g} m/s: {} in step {}", scene.name, judged.meeting.speed, judged.verdict.failure,
               judged.verdict.step);
    const Prediction& wanted = judged.meeting.prediction;
    if (!judged.passes()) {
        fmt::print("; touch at {:.3f} of step {}, from {:.2g} m, {:.2g} m deep in it, other gap {:.2g} m",
                   60.0 * wanted.time, wanted.step, wanted.gap, overlap_of(judged.meeting), wanted.next_gap);
    }
    fmt::print("\n  {}\n", file.string());
}

int fuzz_meetings(const OptionTexts& options) {
    const MeetingRequest request{
        .count = options.meetings, .first_seed = options.seed, .presets = {options.families.preset}};
    const std::vector<JudgedMeeting> judged =
        watched("pairs", 2 * options.meetings, [&](const GoOn& go_on) { return judge_meetings(request, go_on); });
    return conclude(judged, 2 * options.meetings, meeting_table(judged),
                    [&](const JudgedMeeting& one) { report(one, options.out); });
}

void report(const JudgedFall& judged, const std::filesystem::path& folder) {
    demos::make_folder(folder);
    const std::filesystem::path file = folder / (judged.fall.scene.name + ".json");
    demos::write_file(file, demos::scene_file_text(judged.fall.scene));
    fmt::print("{}: {:.2f} thicknesses deep in step {}{}\n  {}\n", judged.fall.scene.name, judged.deepest,
               judged.step, judged.error.empty() ? "" : "; " + judged.error, file.string());
}

int fuzz_thin_falls(const OptionTexts& options) {
    const std::vector<JudgedFall> judged = watched("falls", options.thin_falls, [&](const GoOn& go_on) {
        return judge_thin_falls(options.thin_falls, options.seed, options.families.preset, go_on);
    });
    return conclude(judged, options.thin_falls, thin_fall_table(judged),
                    [&](const JudgedFall& one) { report(one, options.out); });
}

int fuzz_sleepers(const OptionTexts& options) {
    FamilyRequest request = options.families;
    request.members = options.sleepers;
    const std::vector<JudgedSleepers> judged =
        watched("members", request.members, [&](const GoOn& go_on) { return judge_sleepers(request, go_on); });
    return conclude(judged, request.members, sleepers_table(judged), [](const JudgedSleepers& one) {
        fmt::print("{}: moves by {:.2g} of a size {}\n", one.member.command(), one.drift, one.error);
    });
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

int run(const OptionTexts& options) {
    try {
        if (options.families.members > 0) return judge_families(options);
        if (options.sleepers > 0) return fuzz_sleepers(options);
        if (options.meetings > 0) return fuzz_meetings(options);
        if (options.thin_falls > 0) return fuzz_thin_falls(options);
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
    OptionTexts options;
    CLI::App app(
        "Judges random scenes: finite, forces within bounds, momentum and energy kept. A scene that fails "
        "is shrunk and written as a scene file.");
    app.add_option("--scenes", options.scenes, "number of random scenes")
        ->check(CLI::Range(1L, 1'000'000'000L))
        ->capture_default_str();
    app.add_option("--seed", options.seed, "seed of the first; consecutive from there")->capture_default_str();
    app.add_option("--out", options.out, "folder for scenes that fail")->capture_default_str();
    FamilyRequest& families = options.families;
    app.add_option("--families", families.members, "judge this number of members of the families instead")
        ->check(CLI::Range(1L, 1'000'000'000L));
    app.add_option("--family", families.only, "only members of this family [all in turn]");
    app.add_option("--meetings", options.meetings,
                   "judge this number of pairs that pass, and as many that touch, instead")
        ->check(CLI::Range(1L, 1'000'000'000L));
    app.add_option("--thin-falls", options.thin_falls,
                   "judge this number of falls of rods, plates and coins instead")
        ->check(CLI::Range(1L, 1'000'000'000L));
    app.add_option("--sleepers", options.sleepers,
                   "judge what sleeps in this number of members of the families instead")
        ->check(CLI::Range(1L, 1'000'000'000L));
    app.add_option("--preset", families.preset, "preset of the runs of members, pairs and falls")
        ->check(CLI::IsMember({"default", "exact", "paper"}))
        ->capture_default_str();
    app.add_option("--most-bodies", families.most_bodies, "most bodies of a member")->capture_default_str();
    app.add_flag("--page", options.page, "and write a page with pictures of the worst member of each family");
    app.add_flag("--small", families.small, "small members, as in the tests");
    app.add_option("FILE", options.files, "scene files to judge instead");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? demos::done : demos::bad_usage;
    }
    families.first_seed = static_cast<int>(options.seed);
    return run(options);
}
