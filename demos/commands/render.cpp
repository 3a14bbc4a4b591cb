#include "demos/base/platform/messages.h"
#include "demos/base/platform/output_file.h"
#include "demos/base/platform/progress.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/json.h"
#include "demos/commands/commands.h"
#include "demos/commands/run_options.h"
#include "demos/pictures/camera/survey.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/film/film.h"
#include "demos/pictures/film/frame_writer.h"
#include "demos/pictures/film/video.h"
#include "demos/pictures/gltf/glb_record.h"
#include "demos/pictures/lettering.h"
#include "demos/pictures/overlays/overlay.h"
#include "demos/pictures/recorded_session.h"
#include "demos/runs/recorder.h"
#include "demos/runs/scene.h"
#include "demos/runs/trajectory.h"
#include "demos/scenes/scene_file.h"

#include <fmt/format.h>

namespace pushfactor::demos::commands {

namespace {

namespace fs = std::filesystem;

// One scene to render, and its output folder.
struct Job {
    Sequence sequence;
    fs::path folder{};
    std::vector<BuiltScene> built{};  // of the panels
};

Job understand_job(const std::string& scene, const Render& request) {
    Job job{.sequence = plan_sequence(scene, request.given)};
    job.sequence.shard = request.shard.value_or(Shard{});
    note_cut_time(job.sequence, request.given);
    // Before there is a folder for it.
    for (const ComparedRun& panel : job.sequence.panels) {
        job.built.push_back(build_scene(request.timing ? panel.choices.on_one_thread() : panel.choices));
        if (!request.png && !request.video) continue;
        pictures::require_drawable(job.built.back());
        pictures::require_shown(job.built.back(), panel.choices.frames.overlay);
    }
    if (request.from_trajectory) pictures::require_poses_only(job.sequence, *request.from_trajectory);
    if (request.files.glb) pictures::check_glb(*request.files.glb, job.sequence.panels.front().choices);
    const fs::path base = request.out.value_or("out");
    job.folder = request.scenes.size() > 1 || !request.out ? base / job.sequence.scene() : base;
    return job;
}

// Beside config.json: the scene that came from a pipe.
const char* const piped_scene = "config.scene.json";

bool is_piped(const std::string& scene) {
    return !find_scene(scene) && is_stream(scene);
}

// The files of a folder of frames have their names; a scene and other outputs must not take them.
void refuse_own_files(const Job& job, const Render& request, const std::string& scene) {
    std::vector<std::string> files = request.files.all();
    for (const auto* const file : {&request.summary, &request.video}) {
        if (*file) files.push_back(**file);
    }
    files.push_back(scene);
    for (const std::string& file : files) {
        const std::string name = fs::path(file).filename();
        const bool is_own = name == "config.json" || (name == "summary.json" && file != request.summary) ||
                            (name == piped_scene && is_piped(scene)) || job.sequence.frames.front().has(name);
        if (is_own && is_file_of(job.folder, file)) {
            throw UsageError("{}: must have another name: render writes a file of this name there", file);
        }
    }
}

// Writes config.json, and the scene if it came from a pipe. Frames left by an earlier, longer run could be mistaken
// for this run's, but are not ours to delete. Shards of one film write the same file; a folder with another film is
// not for them.
void prepare_folder(const Job& job, const Render& request) {
    const auto strangers = std::ranges::count_if(fs::directory_iterator(job.folder), [&](const auto& entry) {
        return entry.path().extension() == ".png" &&
               !job.sequence.frames.front().has(entry.path().filename().string());
    });
    if (strangers > 0) {
        note(fmt::format("{} holds {} other PNG {} that this run does not touch", job.folder.string(), strangers,
                         strangers == 1 ? "file" : "files"));
    }
    const fs::path file = job.folder / "config.json";
    Choices choices = job.sequence.panels.front().choices;
    std::string scene_text;
    if (is_piped(choices.scene)) {
        SceneDescription description = choices.description;
        if (!choices.settings.measured.empty()) {  // they come with that option again
            std::erase_if(description.bodies, [](const auto& body) { return !body.measured_of.empty(); });
        }
        scene_text = scene_file_text(description);
        choices.scene = (job.folder / piped_scene).string();
    }
    const Json before = json_or_null(read_bytes_of(file).value_or(""));
    if (before.is_object() && before.contains("scene") && before["scene"].is_string() &&
        before["scene"] != choices.scene) {
        note(fmt::format("{} had the pictures of scene {}, and gets those of {}", job.folder.string(),
                         before["scene"].get<std::string>(), choices.scene));
    }
    for (const auto& [path, text] :
         {std::pair{job.folder / piped_scene, scene_text}, std::pair{file, config_text(choices, request.given)}}) {
        if (text.empty()) continue;
        if (!request.shard) {
            write_file(path, text);
            continue;
        }
        if (write_first(path, text)) continue;
        throw UsageError("--shard {}: {} is of another film; remove the folder, or take another --out",
                         to_text(*request.shard), file.string());
    }
}

// Throws what a thread threw; keeps the frames so far.
void make_frames(const Job& job, const Render& request, Session& session, Recorder* recorder,
                 const pictures::Pictures& pictures, pictures::StageTimes* times) {
    const Choices& choices = job.sequence.panels.front().choices;
    pictures::FrameWriter writer(job.folder, request.png, request.video, choices.frames.film_rate(), times,
                                 film_mark(choices, request.given));
    ProgressBar bar(job.sequence.scene(), static_cast<long>(job.sequence.drawn_count()));
    take_frames(session, recorder, pictures, writer.queue(), times, [&](long drawn) { bar.show(drawn); });
    stop_if_interrupted(fmt::format("{} of {} frames were drawn{}", writer.queue().ended(),
                                    job.sequence.drawn_count(),
                                    request.png ? ", into " + job.folder.string() : ""));
    writer.finish();
}

// Without a simulation there is no summary.
void render_trajectory(Job& job, const Render& request, pictures::OffscreenRenderer& offscreen,
                       pictures::StageTimes* times) {
    Trajectory trajectory(*request.from_trajectory, motion_hash(job.sequence.panels.front().choices));
    const Session::GoTo go_to = [&](Simulation& run, long step) {
        if (run.sample().step == 0) trajectory.place(run, 0);  // is it of this run?
        trajectory.place(run, step);
    };
    pictures::SurveyOnce survey(job.sequence.frames, go_to);
    pictures::add_overview(job.sequence.panels, survey);
    Session session(job.sequence, false, go_to, std::move(job.built));
    pictures::Film film(offscreen, session, survey);
    prepare_folder(job, request);
    make_frames(job, request, session, nullptr, {.film = &film}, times);
}

void render_job(Job& job, const Render& request, std::optional<pictures::OffscreenRenderer>& offscreen,
                pictures::StageTimes* times) {
    pictures::SurveyOnce survey(job.sequence.frames);
    pictures::add_overview(job.sequence.panels, survey);
    pictures::RecordedSession recorded(job.sequence, request.files, request.timing, job.folder, survey,
                                       std::move(job.built));
    std::optional<pictures::Film> film;
    if (offscreen) film.emplace(*offscreen, recorded.session, survey);
    prepare_folder(job, request);
    // That of an earlier run would be taken for this one's if this one fails.
    const fs::path summary = request.summary ? fs::path(*request.summary) : job.folder / "summary.json";
    if (!request.summary && !request.shard) fs::remove(summary);
    recorded.play([&] {
        make_frames(job, request, recorded.session, &recorded.recorder,
                    {.film = film ? &*film : nullptr, .replay = recorded.replay ? &*recorded.replay : nullptr},
                    times);
    });
    write_file(summary, summary_text(recorded.session, recorded.finish(), offscreen ? offscreen->driver() : ""));
    say(recorded.recorder.warnings());
}

// On standard error, because data may be on standard output.
void print_times(const std::vector<Job>& jobs, const pictures::StageTimes& times, bool drawn) {
    long frames = 0;
    for (const Job& job : jobs) frames += static_cast<long>(job.sequence.drawn_count());
    const FrameChoices& choices = jobs.front().sequence.panels.front().choices.frames;
    say(times.table(frames));
    if (!drawn) return;
    const pictures::StageTime least = pictures::time_of_empty_frame({choices.width, choices.height}, choices.gl);
    const pictures::StageTime encode = times.sum("encode");
    const pictures::StageTime write = times.sum("write");
    say(fmt::format("the floor (clear and read back {:.2f}, encode and write): {:.2f} ms of CPU time per frame\n",
                    1e3 * least.cpu, 1e3 * (least.cpu + (encode.cpu + write.cpu) / static_cast<double>(frames))));
}

void note_missing_letters(const std::vector<Job>& jobs, const pictures::Lettering& lettering) {
    for (const Job& job : jobs) {
        const Choices& choices = job.sequence.panels.front().choices;
        const std::string caption = pictures::caption_of(choices);
        const std::string_view lacking = lettering.lacks(caption);
        if (!choices.frames.caption || lacking.empty()) continue;
        note(fmt::format("the font has no {} for the caption {}", lacking, caption));
        return;
    }
}

std::vector<Option> render_options() {
    std::vector<Option> table = simulation_option_table();
    const auto add = [&table](const std::vector<Option>& more) {
        table.insert(table.end(), more.begin(), more.end());
    };
    add(output_option_table());
    const std::string frames = "Frames", shares = "Long films on many machines";
    add(frame_option_table(~0u, frames));
    add({
        {"out", "DIR", "folder for the frames; with several scenes one folder per scene in it [out/SCENE]", frames},
        {"video", "FILE",
         "also write a video (.mp4, .webm or .gif, which stays in memory until its end); needs ffmpeg", frames,
         OptionKind::writes},
        {"frames", "on|off", "off: only the video or the replay, no PNG files [on]", frames},
        {"shard", "K/N", "draw only every N-th frame, from the K-th on", shares},
        {"from-trajectory", "FILE", "draw the poses of this file of --trajectory instead of simulating again",
         shares, OptionKind::reads},
        {"join", "DIR", "make the --video of the frames in this folder; draws nothing; may be repeated", shares,
         OptionKind::list},
    });
    return table;
}

AnyCommand read_join(Words& words) {
    Join command{.folders = words.take_all("join"), .video = words.take("video").value_or("")};
    // Further folders may follow without the option.
    const std::vector<std::string> more = words.take_names();
    command.folders.insert(command.folders.end(), more.begin(), more.end());
    if (command.video.empty()) throw UsageError("--join: must be with --video FILE");
    pictures::check_video_name(command.video);
    words.refuse_rest("render --join");
    return command;
}

// What a file can be made of.
enum Needs : unsigned { one_scene = 1, one_run = 2, sequence = 4, simulation = 8, whole = 16 };

AnyCommand read_render(Words& words) {
    if (words.given("join")) return read_join(words);
    Render command;
    command.timing = words.take_flag("timing");
    command.from_trajectory = words.take("from-trajectory");
    command.shard = words.take_shard("shard");
    command.out = words.take("out");
    command.png = words.take_word("frames", {"on", "off"}) != "off";
    command.scenes = words.take_names();
    command.given = take_simulation(words, command.scenes, !command.timing);
    const bool stills = command.given.find("at") != nullptr;

    struct Condition {
        unsigned bit;
        bool holds;
        const char* must;
    };
    const Condition conditions[] = {
        {one_scene, command.scenes.size() == 1, "for one scene at a time"},
        {one_run, !command.given.find("compare"), "for one run, not with --compare"},
        {sequence, !stills, "of a sequence, not of stills (--at)"},
        {simulation, !command.from_trajectory, "without --from-trajectory, which does not simulate"},
        {whole, !command.shard, "with --join, when all shards are drawn, not with --shard"},
    };
    const auto take = [&](const char* option, unsigned needs) {
        for (const Condition& condition : conditions) {
            if ((needs & condition.bit) != 0) words.take(option, condition.holds, condition.must);
        }
        return words.take(option);
    };
    for (const char* const data : {"csv", "trajectory", "rows", "errors", "save-state"}) {
        take(data, one_scene | one_run | simulation);
    }
    take("measure", one_scene | simulation);
    command.summary = take("summary", one_scene | simulation);
    command.video = take("video", one_scene | sequence | whole);
    take("replay", one_scene | sequence | simulation);
    take("glb", one_scene | one_run | sequence | simulation);
    command.files = take_files(words);
    take("from-trajectory", one_scene | one_run);

    const bool draws = command.png || command.video, models = command.files.glb || command.files.replay;
    if (!draws && !command.files.replay) throw UsageError("--frames off: must be with --video or --replay");
    const bool film = !stills && (draws || models);
    take_frames(words, (draws ? of_pictures : 0u) | (draws && words.given("shutter") ? of_shutter : 0u) |
                           (film ? of_film : 0u) | (command.files.trajectory ? of_trajectory : 0u) |
                           (models ? of_models : 0u));
    require_shown_overlays(words, {.pictures = draws,
                                   .glb = command.files.glb.has_value(),
                                   .replay = command.files.replay && !command.files.replay_poses_only});
    if (command.video) pictures::check_video_name(*command.video);
    if (command.files.replay) pictures::check_replay_name(*command.files.replay);
    words.refuse_rest(stills ? "render --at, which makes stills" : draws ? "render" : "render --frames off");
    return command;
}

}  // namespace

void carry_out(const Render& request) {
    if (request.video) pictures::require_ffmpeg(*request.video);
    // All input is checked and all folders are created before the first frame is drawn.
    std::vector<Job> jobs;
    for (const std::string& scene : request.scenes) {
        jobs.push_back(understand_job(scene, request));
        refuse_own_files(jobs.back(), request, scene);
        for (std::size_t i = 0; i + 1 < jobs.size(); ++i) {
            if (jobs[i].folder != jobs.back().folder) continue;
            throw UsageError("scene {}: must not share its folder {}", scene, jobs.back().folder.string());
        }
    }
    std::vector<ComparedRun> runs;
    for (const Job& job : jobs) runs.insert(runs.end(), job.sequence.panels.begin(), job.sequence.panels.end());
    note_idle(request.given, runs);
    for (const Job& job : jobs) make_folder(job.folder);
    std::optional<pictures::StageTimes> times;
    if (request.timing) times.emplace();
    pictures::StageTimes* const watch = times ? &*times : nullptr;
    std::optional<pictures::OffscreenRenderer> offscreen;
    if (request.png || request.video)
        offscreen.emplace(jobs.front().sequence.panels.front().choices.frames.gl, watch);
    if (offscreen) note_missing_letters(jobs, offscreen->lettering());
    if (request.from_trajectory) {
        render_trajectory(jobs.front(), request, offscreen.value(), watch);
    } else {
        for (Job& job : jobs) render_job(job, request, offscreen, watch);
    }
    if (offscreen && offscreen->blank() > 0) {
        note(fmt::format("{}, because nothing is in view of the camera",
                         offscreen->blank() == 1 ? "1 picture is empty"
                                                 : fmt::format("{} pictures are empty", offscreen->blank())));
    }
    if (times) print_times(jobs, *times, offscreen.has_value());
}

const Entry render_entry{"render",       "SCENE...",  "PNG frames or stills, without a display",
                         render_options, read_render, scene_parameters_help};

}  // namespace pushfactor::demos::commands
