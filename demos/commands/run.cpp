#include "demos/commands/commands.h"
#include "demos/commands/run_options.h"
#include "demos/pictures/camera/survey.h"
#include "demos/pictures/gltf/glb_record.h"
#include "demos/pictures/replay/replay.h"
#include "demos/platform/messages.h"
#include "demos/platform/output_file.h"
#include "demos/platform/progress.h"
#include "demos/runs/recorder.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos::commands {

namespace {

std::vector<std::optional<std::string>> data_files(const Run& request) {
    const RunFiles& files = request.files;
    return {files.csv, files.trajectory, files.rows, files.errors, files.save_state, request.glb, request.replay};
}

// Folder of the first output file; the working folder without one.
std::filesystem::path folder_of_outputs(const Run& request) {
    std::vector<std::optional<std::string>> files = data_files(request);
    files.insert(files.begin(), request.summary);
    for (const auto& file : files) {
        if (file && *file != "-") return std::filesystem::path(*file).parent_path();
    }
    return {};
}

// Takes all steps. If something stops them earlier, the files keep the steps so far.
void go_through(Session& session, Recorder& recorder, pictures::Replay* replay, long steps) {
    std::vector<Observer*> observers{&recorder};
    if (replay) observers.push_back(replay);
    try {
        ProgressBar bar(session.sequence().scene(), steps);
        session.play(observers, [&](const Simulation& run) {
            bar.show(run.sample().step);
            stop_if_interrupted(fmt::format("{} of {} steps are done", run.sample().step, steps));
            return true;
        });
        bar.show(steps);
    } catch (const OutputError&) {
        throw;
    } catch (const std::exception& error) {
        say(recorder.keep_records() + (replay ? replay->keep(error.what()) : "") + recorder.warnings());
        throw;
    }
}

std::vector<Option> run_options() {
    std::vector<Option> table = simulation_option_table();
    for (const auto& more :
         {output_option_table(), frame_option_table(of_run, "Frames of --trajectory, --replay and --glb")}) {
        table.insert(table.end(), more.begin(), more.end());
    }
    return table;
}

AnyCommand read_run(Words& words) {
    Run command;
    command.files = take_files(words);
    command.summary = words.take("summary");
    command.glb = words.take("glb");
    command.replay = words.take("replay");
    command.timing = words.take_flag("timing");
    command.line = words.line();
    command.replay_poses_only = take_poses_only(words, command.replay.has_value());
    std::vector<std::string> scenes = words.take_names();
    command.given = take_simulation(words, scenes, !command.timing);
    command.scene = only_scene(scenes);
    const bool models = command.glb || command.replay;
    words.take("fps", models || command.files.trajectory, "with --trajectory, --glb or --replay");
    for (const char* const name : {"camera", "overlay"}) words.take(name, models, "with --glb or --replay");
    require_shown_overlays(words, {.glb = command.glb.has_value(), .replay = command.replay.has_value()});
    if (command.replay) pictures::check_replay_name(*command.replay);
    return command;
}

}  // namespace

void carry_out(const Run& request) {
    std::vector<ComparedRun> runs{{.label = "", .choices = understand(request.scene, request.given)}};
    const Choices& choices = runs.front().choices;
    const long steps = whole_steps(choices.settings);
    note_cut_time(choices);
    const long every = request.replay ? pictures::steps_a_replay_frame(choices) : 1;
    std::vector<Frames> frames;
    pictures::SurveyOnce survey(frames);
    if (request.glb) {
        pictures::check_glb(*request.glb, choices);
        frames.push_back(plan_frames(choices.frames, choices.settings.dt, steps));
        pictures::add_overview(runs, survey);
    }
    Session session({.panels = runs, .frames = {Frames(every, static_cast<std::size_t>(steps / every) + 1)}},
                    request.timing);
    Recorder recorder(session, request.files, request.timing, folder_of_outputs(request));
    if (request.glb) recorder.add(pictures::glb_record(*request.glb, runs, survey, session.run(0)));
    std::optional<pictures::Replay> replay;
    if (request.replay) {
        replay.emplace(pictures::ReplayChoices{.file = *request.replay,
                                               .steps_a_frame = every,
                                               .poses_only = request.replay_poses_only,
                                               .command = request.line},
                       session);
    }
    go_through(session, recorder, replay ? &*replay : nullptr, steps);
    if (replay) replay->finish();
    const std::string summary = recorder.finish().front();
    const std::vector<std::optional<std::string>> data = data_files(request);
    const bool data_on_stdout = std::find(data.begin(), data.end(), "-") != data.end();
    if (request.summary || !data_on_stdout) write_file(request.summary.value_or("-"), summary);
    say(recorder.warnings());
}

Entry run_entry() {
    return {"run",       "SCENE",  "physics only: CSV files and a summary as JSON",
            run_options, read_run, scene_parameters_help};
}

}  // namespace pushfactor::demos::commands
