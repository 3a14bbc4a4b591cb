#include "demos/commands/commands.h"
#include "demos/options/comparison.h"
#include "demos/pictures/film.h"
#include "demos/pictures/frame_writer.h"
#include "demos/pictures/gltf/glb_record.h"
#include "demos/pictures/overview.h"
#include "demos/pictures/replay/replay.h"
#include "demos/platform/output_file.h"
#include "demos/platform/producer.h"
#include "demos/platform/progress.h"
#include "demos/runs/observed_run.h"
#include "demos/text/errors.h"
#include "demos/text/json.h"

#include <fmt/format.h>

namespace pushfactor::demos::commands {

namespace {

namespace fs = std::filesystem;

// One scene to render: its panels, the frames of each, and the output folder.
struct Job {
    std::vector<ComparedRun> panels;
    std::vector<std::vector<Frame>> frames;  // per panel, equally many in each
    fs::path folder;

    const std::string& scene() const { return panels.front().choices.description.name; }

    // A run ends with its last still.
    long last_step(std::size_t panel) const {
        const Choices& choices = panels[panel].choices;
        return choices.frames.at.empty() ? whole_steps(choices.settings) : frames[panel].back().step;
    }
};

// Frames left by an earlier, longer run could be mistaken for this run's, but are not ours to delete.
void warn_of_strangers(const fs::path& folder, const std::vector<Frame>& frames) {
    long strangers = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename();
        const bool ours = std::any_of(frames.begin(), frames.end(), [&](const Frame& f) { return f.name == name; });
        if (entry.path().extension() == ".png" && !ours) ++strangers;
    }
    if (strangers > 0) {
        fmt::print(stderr, "pushfactor: note: {} holds {} other PNG files that this run does not touch\n",
                   folder.string(), strangers);
    }
}

Job understand_job(const std::string& scene, const Request& request) {
    Job job{.panels = compared_runs(scene, request.given), .frames = {}, .folder = {}};
    for (const ComparedRun& panel : job.panels) {
        const Choices& choices = panel.choices;
        job.frames.push_back(plan_frames(choices.frames, choices.settings.dt, whole_steps(choices.settings)));
        if (job.frames.back().size() != job.frames.front().size()) {
            throw UsageError(fmt::format("--compare {}: the panels must have equally many frames, not {} and {}",
                                         panel.label, job.frames.front().size(), job.frames.back().size()));
        }
    }
    if (request.glb) pictures::check_glb(*request.glb, job.panels.front().choices);
    const fs::path base = request.out.value_or("out");
    job.folder = request.scenes.size() > 1 || !request.out ? base / job.scene() : base;
    return job;
}

std::vector<ObservedRun> start_runs(const Job& job, const Request& request) {
    std::vector<ObservedRun> runs;
    for (const ComparedRun& panel : job.panels) {
        runs.emplace_back(panel.choices, request.files, request.timing, job.folder);
    }
    return runs;
}

std::string summary_of(const Job& job, std::vector<ObservedRun>& runs) {
    if (runs.size() == 1) return runs.front().finish();
    Json summary;
    summary["compare"] = job.panels.front().choices.frames.compare->option;
    for (ObservedRun& run : runs) summary["panels"].push_back(Json::parse(run.finish()));
    return summary.dump(2) + "\n";
}

// What is made of a job's runs; either may be absent.
struct Takers {
    std::optional<pictures::Film> film{};
    std::optional<pictures::Replay> replay{};
};

// Steps the runs of a job to each frame and then to the end, records the replay and sends a snapshot per frame,
// which is empty without a film. Stops early when the channel is closed or the program is interrupted.
class Shooting {
  public:
    Shooting(const Job& job, std::vector<ObservedRun>& runs, Takers& takers, pictures::StageTimes* times)
        : job_(job), runs_(runs), takers_(takers), times_(times) {}

    void operator()(Channel<pictures::Snapshot>& moments) {
        const pictures::ThreadWatch thread(times_);
        const std::vector<Frame>& frames = job_.frames.front();
        for (std::size_t frame = 0; frame < frames.size(); ++frame) {
            pictures::StageWatch watch(times_);
            for (std::size_t i = 0; i < runs_.size(); ++i) {
                if (!advance(i, job_.frames[i][frame].step, moments)) return;
            }
            watch.end("simulate");
            if (takers_.replay) takers_.replay->record();
            watch.end("replay");
            pictures::Snapshot moment;
            if (takers_.film) moment = takers_.film->look(frames[frame].name);
            watch.end("look");
            if (!moments.send(std::move(moment))) return;
        }
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            if (!advance(i, job_.last_step(i), moments)) return;
        }
    }

  private:
    bool advance(std::size_t run, long step, const Channel<pictures::Snapshot>& moments) {
        while (runs_[run].simulation().sample().step < step) {
            if (interrupted() || moments.is_closed()) return false;
            runs_[run].advance();
        }
        return true;
    }

    const Job& job_;
    std::vector<ObservedRun>& runs_;
    Takers& takers_;
    pictures::StageTimes* times_;
};

// Simulates on one thread, draws on this one and encodes on others. An error on any of them ends all.
void make_frames(const Job& job, const Request& request, std::vector<ObservedRun>& runs, Takers& takers,
                 pictures::StageTimes* times) {
    const Rational rate = job.panels.front().choices.frames.film_rate();
    pictures::FrameWriter writer(job.folder, request.png, request.video, rate, times);
    const std::size_t count = job.frames.front().size();
    ProgressBar bar(job.scene(), static_cast<long>(count));
    constexpr std::size_t ahead = 2;
    Producer<pictures::Snapshot> moments(ahead, Shooting(job, runs, takers, times));
    long drawn = 0;
    while (const auto moment = moments.next()) {
        if (takers.film) {
            renderer::Image image = writer.blank();
            takers.film->draw(*moment, image);
            writer.write(moment->name, std::move(image));
        }
        bar.show(++drawn);
    }
    writer.flush();
    stop_if_interrupted(fmt::format("{} of {} frames are in {}", writer.written(), count, job.folder.string()));
    writer.finish();
    if (takers.replay) takers.replay->finish();
}

void render_job(Job& job, const Request& request, std::optional<pictures::Studio>& studio,
                pictures::StageTimes* times) {
    pictures::add_overview(job.panels, job.frames);
    std::vector<ObservedRun> runs = start_runs(job, request);
    std::vector<const Simulation*> simulations;
    for (const ObservedRun& run : runs) simulations.push_back(&run.simulation());
    Takers takers;
    if (studio) takers.film.emplace(*studio, job.panels, simulations, job.frames);
    if (request.replay) {
        takers.replay.emplace(
            pictures::ReplayChoices{.file = *request.replay,
                                    .steps_a_frame = job.frames.front().size() > 1 ? job.frames.front()[1].step : 1,
                                    .poses_only = request.replay_poses_only,
                                    .command = request.command_line},
            job.panels, simulations);
    }
    if (request.glb) {
        const pictures::Survey survey = takers.film ? takers.film->survey()
                                        : pictures::needs_survey(job.panels.front().choices.frames)
                                            ? pictures::survey(job.panels, job.frames)
                                            : pictures::Survey{};
        runs.front().add(
            pictures::glb_record(*request.glb, job.panels.front().choices, survey, runs.front().simulation()));
    }
    warn_of_strangers(job.folder, job.frames.front());
    write_file(job.folder / "config.json", config_text(job.panels.front().choices, request.given));
    try {
        make_frames(job, request, runs, takers, times);
    } catch (const OutputError&) {
        throw;
    } catch (const std::exception& error) {
        if (takers.replay) fmt::print(stderr, "{}", takers.replay->keep(error.what()));
        for (std::size_t i = 0; i < runs.size(); ++i) {
            fmt::print(stderr, "{}{}", runs[i].keep_records(), runs[i].warnings(job.panels[i].label));
        }
        throw;
    }
    write_file(request.summary ? fs::path(*request.summary) : job.folder / "summary.json", summary_of(job, runs));
    for (std::size_t i = 0; i < runs.size(); ++i) {
        fmt::print(stderr, "{}", runs[i].warnings(job.panels[i].label));
    }
}

// On standard error, because data may be on standard output.
void print_times(const std::vector<Job>& jobs, const pictures::StageTimes& times) {
    long frames = 0;
    for (const Job& job : jobs) frames += static_cast<long>(job.frames.front().size());
    const FrameChoices& choices = jobs.front().panels.front().choices.frames;
    fmt::print(stderr, "{}", times.table(frames));
    const pictures::StageTime least = pictures::time_of_empty_frame({choices.width, choices.height}, choices.gl);
    const pictures::StageTime encode = times.sum("encode");
    const pictures::StageTime write = times.sum("write");
    fmt::print(stderr,
               "the floor (clear and read back {:.2f}, encode and write): {:.2f} ms of CPU time per frame\n",
               1e3 * least.cpu, 1e3 * (least.cpu + (encode.cpu + write.cpu) / static_cast<double>(frames)));
}

// An option that names one file cannot serve several scenes or panels.
void refuse_shared_files(const Request& request) {
    const bool several = request.scenes.size() > 1;
    const bool compares = request.given.find("compare") != nullptr;
    for (const auto& [option, path] :
         {std::pair{"--csv", request.files.csv}, std::pair{"--trajectory", request.files.trajectory},
          std::pair{"--rows", request.files.rows}, std::pair{"--summary", request.summary},
          std::pair{"--save-state", request.files.save_state}, std::pair{"--video", request.video},
          std::pair{"--replay", request.replay}, std::pair{"--glb", request.glb}}) {
        if (several && path) throw UsageError(fmt::format("{} {}: must be for one scene at a time", option, *path));
        const bool one_for_all = option == std::string_view("--summary") || option == std::string_view("--video") ||
                                 option == std::string_view("--replay");
        if (compares && path && !one_for_all) {
            throw UsageError(fmt::format("{} {}: must be for one run, not with --compare", option, *path));
        }
    }
    for (const auto& [option, path] :
         {std::pair{"--video", request.video}, std::pair{"--replay", request.replay}}) {
        if (!path || !request.given.find("at")) continue;
        throw UsageError(fmt::format("{} {}: must be of a sequence, not of stills (--at)", option, *path));
    }
    if (!request.png && !request.video && !request.replay) {
        throw UsageError("--frames off: must come with --video or --replay");
    }
    if (request.video) pictures::check_video_name(*request.video);
    if (request.replay) pictures::check_replay_name(*request.replay);
}

}  // namespace

void render(const Request& request) {
    refuse_shared_files(request);
    if (request.video) pictures::require_ffmpeg(*request.video);
    // All input is checked and all folders are created before the first frame is drawn.
    std::vector<Job> jobs;
    for (const std::string& scene : request.scenes) {
        jobs.push_back(understand_job(scene, request));
        for (std::size_t i = 0; i + 1 < jobs.size(); ++i) {
            if (jobs[i].folder != jobs.back().folder) continue;
            throw UsageError(
                fmt::format("scene {}: must not share its folder {}", scene, jobs.back().folder.string()));
        }
    }
    for (const Job& job : jobs) make_folder(job.folder);
    std::optional<pictures::StageTimes> times;
    if (request.timing) times.emplace();
    pictures::StageTimes* const watch = times ? &*times : nullptr;
    std::optional<pictures::Studio> studio;
    if (request.png || request.video) studio.emplace(jobs.front().panels.front().choices.frames.gl, watch);
    for (Job& job : jobs) render_job(job, request, studio, watch);
    if (times) print_times(jobs, *times);
}

}  // namespace pushfactor::demos::commands
