#include "demos/pictures/checks/folder_check.h"

#include "demos/base/platform/output_file.h"
#include "demos/base/platform/progress.h"
#include "demos/base/text/errors.h"
#include "demos/pictures/checks/trajectory.h"
#include "demos/pictures/checks/worst_pictures.h"
#include "demos/pictures/film/film.h"
#include "demos/runs/recorder.h"
#include "renderer/base/renderer_error.h"
#include "renderer/images/read_png.h"

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <set>
#include <utility>

namespace pushfactor::demos::checks {

namespace {

namespace fs = std::filesystem;
using pictures::FrameQueue;
using pictures::process_time;
using pictures::StageWatch;

// Takes the verdicts in the order of the pictures.
class PictureVerdicts {
  public:
    // Pictures that differ go to `update` unless it is null.
    explicit PictureVerdicts(const FolderJob& job, Update* update = nullptr)
        : worst_(job.pages / job.anchor), update_(update) {}

    FrameQueue::End of(const std::function<Compared()>& compare) {
        const double start = process_time().wall;
        auto compared = std::make_shared<Compared>(compare());
        compared->verdict.seconds = process_time().wall - start;
        return [this, compared](StageWatch&) { take(*compared); };
    }

    std::vector<PictureVerdict> all() {
        worst_.mark(verdicts_);
        return verdicts_;
    }

  private:
    void take(const Compared& compared) {
        worst_.offer(compared);
        if (update_ && !compared.verdict.holds()) {
            write_file(update_->staged(compared.verdict.name), compared.actual);
        }
        verdicts_.push_back(compared.verdict);
    }

    WorstPictures worst_;
    Update* update_;
    std::vector<PictureVerdict> verdicts_;
};

// Frames that were not drawn, because the run ended early.
void add_missing(const Sequence& sequence, std::vector<PictureVerdict>& verdicts) {
    for (std::size_t i = verdicts.size(); i < sequence.frame_count(); ++i) {
        verdicts.push_back(
            refused(sequence.frames.front()[i].name, Finding::missing, "not drawn: the run ended before"));
    }
}

// PNG files below a folder, by their paths in it.
std::set<std::string> pictures_below(const fs::path& folder) {
    std::set<std::string> names;
    for (const fs::path& file : files_below(folder)) {
        if (is_png(file)) names.insert(file.lexically_relative(folder).generic_string());
    }
    return names;
}

// The images of the second folder, compared with the first by the threads of a queue.
Compared compare_files(const Comparison& comparison, const fs::path& expected, const fs::path& actual) {
    const std::optional<Bytes> before = read_bytes(expected), now = read_bytes(actual);
    Compared compared;
    try {
        const renderer::Image image = renderer::decode_png(now.value_or(Bytes{}));
        if (before == now) return compared;
        return compare(comparison, expected, image, *now);
    } catch (const renderer::RendererError& error) {
        compared.verdict = refused("", Finding::unreadable, error.what());
        compared.expected = before.value_or(Bytes{});
        return compared;
    }
}

}  // namespace

Update::Update(fs::path folder) : folder_(std::move(folder)), staging_(folder_ / ".new") {
    make_folder(folder_);
    make_folder(staging_);
}

Update::~Update() {
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
}

long Update::apply() {
    long count = 0;
    for (const auto& entry : fs::directory_iterator(staging_)) {
        std::error_code error;
        const fs::path target = folder_ / entry.path().filename();
        if (fs::is_symlink(target, error)) {
            write_file(target, read_bytes_of(entry.path()).value_or(""));
        } else {
            fs::rename(entry.path(), target, error);
            if (error) throw OutputError("{}: {}", target.string(), error.message());
        }
        ++count;
    }
    return count;
}

FolderVerdict check_folder(const Expectation& expected, const Rules& rules, const FolderJob& job,
                           pictures::OffscreenRenderer& offscreen, Update* update) {
    const double start = process_time().wall;
    Sequence sequence = expected.sequence;
    pictures::SurveyOnce survey(sequence.frames);
    pictures::add_overview(sequence.panels, survey);
    Session session(sequence);
    RunFiles files;
    if (update && rules.trajectory) files.trajectory = update->staged("trajectory.csv").string();
    Recorder recorder(session, files, false, job.pages / job.anchor);
    TrajectoryCheck* trajectory = nullptr;
    const fs::path trajectory_file = expected.folder / "trajectory.csv";
    if (rules.trajectory && fs::exists(trajectory_file)) {
        auto record = std::make_unique<TrajectoryCheck>(trajectory_file, *rules.trajectory);
        trajectory = record.get();
        trajectory->observe(session.run(0));
        recorder.add(std::move(record));
    }
    pictures::Film film(offscreen, session, survey);

    const bool same = expected.was_made_with(offscreen.driver());
    const Tolerance tolerance = rules.tolerance.value_or(same ? exactly() : usual());
    FolderVerdict verdict{.name = job.name, .anchor = job.anchor, .how = tolerance.text()};
    const Comparison comparison{.tolerance = tolerance,
                                .film = film_mark(sequence.panels.front().choices, expected.given),
                                .same_bytes = same};
    PictureVerdicts verdicts(job, update);
    try {
        FrameQueue queue([&](const std::string& name, const renderer::Image& image, StageWatch&) {
            return verdicts.of([&] { return compare(comparison, expected.folder / name, image); });
        });
        take_frames(session, &recorder, {.film = &film}, queue, nullptr, job.progress);
    } catch (const NonFiniteError& error) {
        verdict.runs.push_back({.subject = "run", .holds = false, .text = error.what()});
        verdict.made = false;
    }
    stop_if_interrupted("no expected file was changed");
    verdict.pictures = verdicts.all();
    add_missing(sequence, verdict.pictures);
    verdict.unexpected = expected.unexpected();
    const std::string summary = summary_text(session, recorder.finish(), offscreen.driver());
    for (RunVerdict& one : compare_runs(expected, parse_json(summary), rules.physics && !rules.trajectory)) {
        verdict.runs.push_back(std::move(one));
    }
    if (trajectory) {
        verdict.runs.push_back(trajectory->verdict());
    } else if (rules.trajectory) {
        verdict.runs.push_back(
            {.subject = "physics",
             .text = fmt::format("there is no trajectory.csv, as `render --trajectory {}` writes it",
                                 trajectory_file.string()),
             .compared = false});
    }
    if (update && verdict.failures() + verdict.not_compared() > 0) {
        write_file(update->staged("summary.json"), summary);
    } else if (update) {
        std::error_code ignored;
        fs::remove(update->staged("trajectory.csv"), ignored);
    }
    verdict.seconds = process_time().wall - start;
    return verdict;
}

FolderVerdict check_pictures(const fs::path& expected, const fs::path& actual, const Tolerance& tolerance,
                             const FolderJob& job) {
    const double start = process_time().wall;
    const std::set<std::string> names = pictures_below(expected), others = pictures_below(actual);
    if (names.empty()) {
        throw UsageError("check {}: must have PNG files in it or below", expected.string());
    }
    FolderVerdict verdict{.name = job.name, .anchor = job.anchor, .how = tolerance.text()};
    for (const std::string& name : others) {
        if (!names.contains(name)) verdict.unexpected.push_back(name);
    }
    PictureVerdicts verdicts(job);
    FrameQueue queue([&](const std::string& name, const renderer::Image&, StageWatch&) {
        return verdicts.of([&] {
            if (!others.contains(name)) return Compared{.verdict = refused(name, Finding::missing, "missing")};
            Compared compared = compare_files({.tolerance = tolerance}, expected / name, actual / name);
            compared.verdict.name = name;
            return compared;
        });
    });
    long done = 0;
    for (const std::string& name : names) {
        if (interrupted()) break;
        queue.send(name, {});
        job.progress(++done);
    }
    queue.flush();
    stop_if_interrupted("no file was changed");
    verdict.pictures = verdicts.all();
    verdict.seconds = process_time().wall - start;
    return verdict;
}

}  // namespace pushfactor::demos::checks
