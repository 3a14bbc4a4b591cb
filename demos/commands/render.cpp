#include "demos/commands/commands.h"
#include "demos/commands/join.h"
#include "demos/pictures/film/frame_writer.h"
#include "demos/pictures/film/sequence.h"
#include "demos/pictures/gltf/glb_record.h"
#include "demos/pictures/overview.h"
#include "demos/platform/output_file.h"
#include "demos/platform/progress.h"
#include "demos/runs/observed_run.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

namespace pushfactor::demos::commands {

namespace {

namespace fs = std::filesystem;

// One scene to render, and its output folder.
struct Job {
    pictures::Sequence sequence;
    fs::path folder;
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
    Job job{.sequence = pictures::plan_sequence(scene, request.given), .folder = {}};
    if (request.shard) {
        const auto shard = parse_shard(*request.shard);
        if (!shard)
            throw UsageError(fmt::format("--shard {}: must be K/N with 1 <= K <= N <= 1000000", *request.shard));
        job.sequence.shard = *shard;
    }
    if (request.from_trajectory) pictures::require_poses_only(job.sequence, *request.from_trajectory);
    if (request.glb) pictures::check_glb(*request.glb, job.sequence.panels.front().choices);
    const fs::path base = request.out.value_or("out");
    job.folder = request.scenes.size() > 1 || !request.out ? base / job.sequence.scene() : base;
    return job;
}

std::vector<ObservedRun> start_runs(const Job& job, const Request& request) {
    std::vector<ObservedRun> runs;
    for (const ComparedRun& panel : job.sequence.panels) {
        runs.emplace_back(panel.choices, request.files, request.timing, job.folder);
    }
    return runs;
}

// Throws what a thread threw; keeps the frames so far.
void make_frames(const Job& job, const Request& request, std::vector<ObservedRun>& runs, pictures::Takers& takers,
                 pictures::StageTimes* times) {
    const Rational rate = job.sequence.panels.front().choices.frames.film_rate();
    pictures::FrameWriter writer(job.folder, request.png, request.video, rate, times);
    ProgressBar bar(job.sequence.scene(), static_cast<long>(job.sequence.drawn_count()));
    take_frames(job.sequence, runs, takers, writer.queue(), times, [&](long drawn) { bar.show(drawn); });
    stop_if_interrupted(fmt::format("{} of {} frames are in {}", writer.queue().ended(), job.sequence.drawn_count(),
                                    job.folder.string()));
    writer.finish();
    if (takers.replay) takers.replay->finish();
}

// Without a simulation there is no summary.
void render_trajectory(Job& job, const Request& request, pictures::Studio& studio, pictures::StageTimes* times) {
    Trajectory trajectory(*request.from_trajectory);
    const pictures::GoTo go_to = [&](Simulation& run, long step) { trajectory.place(run, step); };
    pictures::add_overview(job.sequence.panels, job.sequence.frames, go_to);
    const Choices& choices = job.sequence.panels.front().choices;
    Simulation simulation(choices);
    const pictures::Film film(studio, job.sequence.panels, {&simulation}, job.sequence.frames, go_to);
    warn_of_strangers(job.folder, job.sequence.frames.front());
    write_file(job.folder / "config.json", config_text(choices, request.given));
    pictures::FrameWriter writer(job.folder, request.png, request.video, choices.frames.film_rate(), times);
    ProgressBar bar(job.sequence.scene(), static_cast<long>(job.sequence.drawn_count()));
    draw_frames(job.sequence, simulation, trajectory, film, writer.queue(), [&](long drawn) { bar.show(drawn); });
    stop_if_interrupted(fmt::format("{} of {} frames are in {}", writer.queue().ended(), job.sequence.drawn_count(),
                                    job.folder.string()));
    writer.finish();
}

void render_job(Job& job, const Request& request, std::optional<pictures::Studio>& studio,
                pictures::StageTimes* times) {
    pictures::add_overview(job.sequence.panels, job.sequence.frames);
    std::vector<ObservedRun> runs = start_runs(job, request);
    std::vector<const Simulation*> simulations;
    for (const ObservedRun& run : runs) simulations.push_back(&run.simulation());
    pictures::Takers takers;
    if (studio) takers.film.emplace(*studio, job.sequence.panels, simulations, job.sequence.frames);
    if (request.replay) {
        takers.replay.emplace(
            pictures::ReplayChoices{
                .file = *request.replay,
                .steps_a_frame = job.sequence.frames.front().size() > 1 ? job.sequence.frames.front()[1].step : 1,
                .poses_only = request.replay_poses_only,
                .command = request.command_line},
            job.sequence.panels, simulations);
    }
    if (request.glb) {
        const pictures::Survey survey = takers.film ? takers.film->survey()
                                        : pictures::needs_survey(job.sequence.panels.front().choices.frames)
                                            ? pictures::survey(job.sequence.panels, job.sequence.frames)
                                            : pictures::Survey{};
        runs.front().add(pictures::glb_record(*request.glb, job.sequence.panels.front().choices, survey,
                                              runs.front().simulation()));
    }
    warn_of_strangers(job.folder, job.sequence.frames.front());
    write_file(job.folder / "config.json", config_text(job.sequence.panels.front().choices, request.given));
    try {
        make_frames(job, request, runs, takers, times);
    } catch (const OutputError&) {
        throw;
    } catch (const std::exception& error) {
        if (takers.replay) fmt::print(stderr, "{}", takers.replay->keep(error.what()));
        for (std::size_t i = 0; i < runs.size(); ++i) {
            fmt::print(stderr, "{}{}", runs[i].keep_records(), runs[i].warnings(job.sequence.panels[i].label));
        }
        throw;
    }
    write_file(request.summary ? fs::path(*request.summary) : job.folder / "summary.json",
               finish(job.sequence, runs, studio ? studio->driver() : ""));
    for (std::size_t i = 0; i < runs.size(); ++i) {
        fmt::print(stderr, "{}", runs[i].warnings(job.sequence.panels[i].label));
    }
}

// On standard error, because data may be on standard output.
void print_times(const std::vector<Job>& jobs, const pictures::StageTimes& times) {
    long frames = 0;
    for (const Job& job : jobs) frames += static_cast<long>(job.sequence.frames.front().size());
    const FrameChoices& choices = jobs.front().sequence.panels.front().choices.frames;
    fmt::print(stderr, "{}", times.table(frames));
    const pictures::StageTime least = pictures::time_of_empty_frame({choices.width, choices.height}, choices.gl);
    const pictures::StageTime encode = times.sum("encode");
    const pictures::StageTime write = times.sum("write");
    fmt::print(stderr,
               "the floor (clear and read back {:.2f}, encode and write): {:.2f} ms of CPU time per frame\n",
               1e3 * least.cpu, 1e3 * (least.cpu + (encode.cpu + write.cpu) / static_cast<double>(frames)));
}

// A film from a trajectory has nothing to write about a run.
void refuse_simulation(const Request& request) {
    if (request.scenes.size() > 1) {
        throw UsageError(
            fmt::format("--from-trajectory {}: must be for one scene at a time", *request.from_trajectory));
    }
    for (const auto& [option, path] :
         {std::pair{"--csv", request.files.csv}, std::pair{"--trajectory", request.files.trajectory},
          std::pair{"--rows", request.files.rows}, std::pair{"--summary", request.summary},
          std::pair{"--save-state", request.files.save_state}, std::pair{"--replay", request.replay},
          std::pair{"--glb", request.glb}}) {
        if (!path) continue;
        throw UsageError(
            fmt::format("{} {}: must not be with --from-trajectory, which does not simulate", option, *path));
    }
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
    if (request.shard && request.video) {
        throw UsageError(fmt::format("--video {}: must be with --join, when all shards are drawn, not with --shard",
                                     *request.video));
    }
    if (request.from_trajectory) refuse_simulation(request);
    if (!request.png && !request.video && !request.replay) {
        throw UsageError("--frames off: must come with --video or --replay");
    }
    if (request.video) pictures::check_video_name(*request.video);
    if (request.replay) pictures::check_replay_name(*request.replay);
}

}  // namespace

void render(const Request& request) {
    if (!request.joined.empty()) {
        join(request);
        return;
    }
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
    if (request.png || request.video) studio.emplace(jobs.front().sequence.panels.front().choices.frames.gl, watch);
    if (request.from_trajectory) {
        render_trajectory(jobs.front(), request, studio.value(), watch);
    } else {
        for (Job& job : jobs) render_job(job, request, studio, watch);
    }
    if (times) print_times(jobs, *times);
}

}  // namespace pushfactor::demos::commands
