#include "demos/commands/commands.h"
#include "demos/commands/run_options.h"
#include "demos/pictures/camera/survey.h"
#include "demos/pictures/gltf/glb_record.h"
#include "demos/pictures/replay/replay.h"
#include "demos/platform/messages.h"
#include "demos/platform/output_file.h"
#include "demos/platform/progress.h"
#include "demos/runs/observed_run.h"
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
void go_through(ObservedRun& observed, const std::string& name, long steps, pictures::Replay* replay, long every) {
    try {
        ProgressBar bar(name, steps);
        if (replay) replay->record();
        for (long step = 1; step <= steps; ++step) {
            stop_if_interrupted(fmt::format("{} of {} steps are done", step - 1, steps));
            observed.advance();
            if (replay && step % every == 0) replay->record();
            bar.show(step);
        }
    } catch (const OutputError&) {
        throw;
    } catch (const std::exception& error) {
        say(observed.keep_records() + (replay ? replay->keep(error.what()) : "") + observed.warnings());
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
    ObservedRun observed(choices, request.files, request.timing, folder_of_outputs(request));
    if (request.glb) observed.add(pictures::glb_record(*request.glb, runs, survey, observed.simulation()));
    std::optional<pictures::Replay> replay;
    if (request.replay) {
        replay.emplace(pictures::ReplayChoices{.file = *request.replay,
                                               .steps_a_frame = every,
                                               .poses_only = request.replay_poses_only,
                                               .command = request.line},
                       runs, std::vector{&observed.simulation()});
    }
    go_through(observed, choices.description.name, steps, replay ? &*replay : nullptr, every);
    if (replay) replay->finish();
    const std::string summary = observed.finish();
    const std::vector<std::optional<std::string>> data = data_files(request);
    const bool data_on_stdout = std::find(data.begin(), data.end(), "-") != data.end();
    if (request.summary || !data_on_stdout) write_file(request.summary.value_or("-"), summary);
    say(observed.warnings());
}

Entry run_entry() {
    return {"run",       "SCENE",  "physics only: CSV files and a summary as JSON",
            run_options, read_run, scene_parameters_help};
}

}  // namespace pushfactor::demos::commands
