#include "demos/reports/check/folder_check.h"

#include "demos/pictures/camera/survey.h"
#include "demos/platform/progress.h"
#include "demos/reports/check/comparison.h"
#include "demos/reports/check/exhibits.h"
#include "demos/reports/check/stopwatch.h"
#include "demos/reports/check/trajectory.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace pushfactor::demos::reports::check {

namespace {

namespace fs = std::filesystem;
using pictures::FrameQueue;
using pictures::Sequence;
using pictures::StageWatch;

// Of a run, step by step. It has no file of its own.
class TrajectoryRecord final : public Record {
  public:
    explicit TrajectoryRecord(std::shared_ptr<TrajectoryCheck> check) : check_(std::move(check)) {}
    void observe(const Simulation& simulation) override { check_->observe(simulation); }
    void finish() override {}
    std::string file_name() const override { return ""; }

  private:
    std::shared_ptr<TrajectoryCheck> check_;
};

// Takes the verdicts in the order of the frames.
class Jury {
  public:
    Jury(const fs::path& folder, const Comparison& comparison, const FolderJob& job, Update* update)
        : folder_(folder), comparison_(comparison), exhibits_(job.pages / job.anchor), update_(update) {}

    FrameQueue::End look(const std::string& name, const renderer::Image& image, StageWatch&) {
        const Stopwatch own;
        auto compared = std::make_shared<Compared>(compare(comparison_, folder_ / name, image));
        compared->verdict.seconds = own.seconds();
        return [this, compared](StageWatch&) { take(*compared); };
    }

    void take(const Compared& compared) {
        exhibits_.offer(compared);
        if (update_ && !compared.verdict.holds()) update_->stage(compared.verdict.name, compared.actual);
        verdicts_.push_back(compared.verdict);
    }

    std::vector<PictureVerdict> verdicts() {
        exhibits_.mark(verdicts_);
        return verdicts_;
    }

  private:
    const fs::path& folder_;
    Comparison comparison_;
    Exhibits exhibits_;
    Update* update_;
    std::vector<PictureVerdict> verdicts_;
};

// Frames that were not drawn, because the run ended early.
void add_missing(const Sequence& sequence, std::vector<PictureVerdict>& verdicts) {
    for (std::size_t i = verdicts.size(); i < sequence.frame_count(); ++i) {
        verdicts.push_back(without(sequence.frames.front()[i].name, "not drawn: the run ended before"));
    }
}

std::vector<ObservedRun> start_runs(const Sequence& sequence, const FolderJob& job, const Rules& rules,
                                    const Update* update) {
    RunFiles files;
    if (update && rules.trajectory) files.trajectory = update->staged("trajectory.csv").string();
    std::vector<ObservedRun> runs;
    for (const ComparedRun& panel : sequence.panels) {
        runs.emplace_back(panel.choices, files, false, job.pages / job.anchor);
    }
    return runs;
}

}  // namespace

FolderVerdict check_folder(const Expectation& expected, const Rules& rules, const FolderJob& job,
                           pictures::Studio& studio, Update* update) {
    const Stopwatch stopwatch;
    Sequence sequence = expected.sequence;
    pictures::SurveyOnce survey(sequence.frames);
    pictures::add_overview(sequence.panels, survey);
    std::vector<ObservedRun> runs = start_runs(sequence, job, rules, update);
    std::shared_ptr<TrajectoryCheck> trajectory;
    const bool has_trajectory = fs::exists(expected.folder / "trajectory.csv");
    if (rules.physics && rules.trajectory && has_trajectory) {
        trajectory = std::make_shared<TrajectoryCheck>(expected.folder / "trajectory.csv", *rules.trajectory);
        trajectory->observe(runs.front().simulation());
        runs.front().add(std::make_unique<TrajectoryRecord>(trajectory));
    }
    std::vector<const Simulation*> simulations;
    for (const ObservedRun& run : runs) simulations.push_back(&run.simulation());
    pictures::Takers takers;
    takers.film.emplace(studio, sequence.panels, simulations, survey);

    const bool same = expected.was_made_with(studio.driver());
    const Tolerance tolerance = rules.tolerance.value_or(same ? exactly() : usual());
    FolderVerdict verdict{.name = job.name, .anchor = job.anchor, .how = tolerance.text()};
    Jury jury(expected.folder,
              {.tolerance = tolerance,
               .film = film_mark(sequence.panels.front().choices, expected.given),
               .same_bytes = same},
              job, update);
    try {
        FrameQueue queue([&](const std::string& name, const renderer::Image& image,
                             StageWatch& watch) { return jury.look(name, image, watch); },
                         nullptr);
        take_frames(sequence, runs, takers, queue, nullptr, job.progress);
    } catch (const NonFiniteError& error) {
        verdict.runs.push_back({.subject = "run", .holds = false, .text = error.what()});
    }
    stop_if_interrupted("no expected file was changed");
    verdict.pictures = jury.verdicts();
    add_missing(sequence, verdict.pictures);
    verdict.unexpected = expected.unexpected();
    const std::string summary = finish(sequence, runs, studio.driver());
    for (RunVerdict& one : compare_runs(expected, Json::parse(summary), rules.physics && !rules.trajectory)) {
        verdict.runs.push_back(std::move(one));
    }
    if (trajectory) verdict.runs.push_back(trajectory->verdict());
    if (rules.physics && rules.trajectory && !has_trajectory) {
        verdict.runs.push_back(
            {.subject = "physics",
             .text = fmt::format("there is no trajectory.csv, as `render --trajectory {}` writes it",
                                 (expected.folder / "trajectory.csv").string()),
             .compared = false});
    }
    if (update && verdict.failures() + verdict.not_compared() > 0) {
        update->stage("summary.json", summary);
    } else if (update) {
        update->drop("trajectory.csv");
    }
    verdict.seconds = stopwatch.seconds();
    return verdict;
}

}  // namespace pushfactor::demos::reports::check
