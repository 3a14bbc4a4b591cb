#include "demos/checks/folder_check.h"

#include "demos/checks/comparison.h"
#include "demos/checks/trajectory.h"
#include "demos/checks/worst_pictures.h"
#include "demos/pictures/film/film.h"
#include "demos/platform/progress.h"
#include "demos/runs/recorder.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace pushfactor::demos::checks {

namespace {

namespace fs = std::filesystem;
using pictures::FrameQueue;
using pictures::StageWatch;

// Takes the verdicts in the order of the frames.
class PictureVerdicts {
  public:
    PictureVerdicts(const fs::path& folder, const Comparison& comparison, const FolderJob& job, Update* update)
        : folder_(folder), comparison_(comparison), worst_(job.pages / job.anchor), update_(update) {}

    FrameQueue::End look(const std::string& name, const renderer::Image& image, StageWatch&) {
        const Stopwatch own;
        auto compared = std::make_shared<Compared>(compare(comparison_, folder_ / name, image));
        compared->verdict.seconds = own.seconds();
        return [this, compared](StageWatch&) { take(*compared); };
    }

    void take(const Compared& compared) {
        worst_.offer(compared);
        if (update_ && !compared.verdict.holds()) update_->stage(compared.verdict.name, compared.actual);
        verdicts_.push_back(compared.verdict);
    }

    std::vector<PictureVerdict> verdicts() {
        worst_.mark(verdicts_);
        return verdicts_;
    }

  private:
    const fs::path& folder_;
    Comparison comparison_;
    WorstPictures worst_;
    Update* update_;
    std::vector<PictureVerdict> verdicts_;
};

// Frames that were not drawn, because the run ended early.
void add_missing(const Sequence& sequence, std::vector<PictureVerdict>& verdicts) {
    for (std::size_t i = verdicts.size(); i < sequence.frame_count(); ++i) {
        verdicts.push_back(without(sequence.frames.front()[i].name, "not drawn: the run ended before"));
    }
}

}  // namespace

FolderVerdict check_folder(const Expectation& expected, const Rules& rules, const FolderJob& job,
                           pictures::OffscreenRenderer& offscreen, Update* update) {
    const Stopwatch stopwatch;
    Sequence sequence = expected.sequence;
    pictures::SurveyOnce survey(sequence.frames);
    pictures::add_overview(sequence.panels, survey);
    Session session(sequence);
    RunFiles files;
    if (update && rules.trajectory) files.trajectory = update->staged("trajectory.csv").string();
    Recorder recorder(session, files, false, job.pages / job.anchor);
    TrajectoryCheck* trajectory = nullptr;
    const bool has_trajectory = fs::exists(expected.folder / "trajectory.csv");
    if (rules.physics && rules.trajectory && has_trajectory) {
        auto record = std::make_unique<TrajectoryCheck>(expected.folder / "trajectory.csv", *rules.trajectory);
        trajectory = record.get();
        trajectory->observe(session.run(0));
        recorder.add(std::move(record));
    }
    pictures::Film film(offscreen, session, survey);

    const bool same = expected.was_made_with(offscreen.driver());
    const Tolerance tolerance = rules.tolerance.value_or(same ? exactly() : usual());
    FolderVerdict verdict{.name = job.name, .anchor = job.anchor, .how = tolerance.text()};
    PictureVerdicts compared(expected.folder,
                             {.tolerance = tolerance,
                              .film = film_mark(sequence.panels.front().choices, expected.given),
                              .same_bytes = same},
                             job, update);
    try {
        FrameQueue queue([&](const std::string& name, const renderer::Image& image,
                             StageWatch& watch) { return compared.look(name, image, watch); },
                         nullptr);
        take_frames(session, &recorder, {.film = &film}, queue, nullptr, job.progress);
    } catch (const NonFiniteError& error) {
        verdict.runs.push_back({.subject = "run", .holds = false, .text = error.what()});
        verdict.made = false;
    }
    stop_if_interrupted("no expected file was changed");
    verdict.pictures = compared.verdicts();
    add_missing(sequence, verdict.pictures);
    verdict.unexpected = expected.unexpected();
    const std::string summary = summary_of(session, recorder.finish(), offscreen.driver());
    for (RunVerdict& one : compare_runs(expected, parse_json(summary), rules.physics && !rules.trajectory)) {
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

}  // namespace pushfactor::demos::checks
