#include "demos/base/platform/messages.h"
#include "demos/base/platform/output_file.h"
#include "demos/base/platform/progress.h"
#include "demos/commands/commands.h"
#include "demos/commands/run_options.h"
#include "demos/pictures/gltf/glb_record.h"
#include "demos/pictures/recorded_session.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos::commands {

namespace {

// Folder of the first output file; the working folder without one.
std::filesystem::path folder_of_outputs(const Run& request) {
    std::vector<std::string> files = request.files.all();
    if (request.summary) files.insert(files.begin(), *request.summary);
    const auto file = std::ranges::find_if_not(files, is_stream);
    return file == files.end() ? std::filesystem::path() : followed(*file).parent_path();
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
    RunFiles& files = command.files;
    files = take_files(words);
    command.summary = words.take("summary");
    command.timing = words.take_flag("timing");
    std::vector<std::string> scenes = words.take_names();
    command.given = take_simulation(words, scenes, !command.timing);
    command.scene = only_scene(scenes);
    const bool models = files.glb || files.replay;
    words.take("fps", models || files.trajectory, "with --trajectory, --glb or --replay");
    for (const char* const name : {"camera", "overlay"}) words.take(name, models, "with --glb or --replay");
    require_shown_overlays(words,
                           {.glb = files.glb.has_value(), .replay = files.replay && !files.replay_poses_only});
    if (files.replay) pictures::check_replay_name(*files.replay);
    return command;
}

}  // namespace

void carry_out(const Run& request) {
    const RunFiles& files = request.files;
    Sequence sequence{.panels = {{.label = "", .choices = understand(request.scene, request.given)}},
                      .frames = std::vector<Frames>(1)};
    const Choices& choices = sequence.panels.front().choices;
    const long steps = whole_steps(choices.settings);
    note_cut_time(sequence, request.given);
    note_idle(request.given, sequence.panels);
    if (files.replay) sequence.frames = {pictures::replay_frames(choices)};
    std::vector<Frames> keys;  // of the glTF file
    pictures::SurveyOnce survey(keys);
    if (files.glb) {
        pictures::check_glb(*files.glb, choices);
        keys.push_back(plan_frames(choices.frames, choices.settings.dt, steps));
        pictures::add_overview(sequence.panels, survey);
    }
    pictures::RecordedSession recorded(sequence, files, request.timing, folder_of_outputs(request), survey);
    recorded.play([&] {
        std::vector<Observer*> observers{&recorded.recorder};
        if (recorded.replay) observers.push_back(&*recorded.replay);
        ProgressBar bar(sequence.scene(), steps);
        recorded.session.play(observers, [&](const Simulation& run) {
            bar.show(run.sample().step);
            stop_if_interrupted(fmt::format("{} of {} steps are done", run.sample().step, steps));
            return true;
        });
        bar.show(steps);
    });
    const std::string summary = json_text(recorded.finish().front());
    const std::vector<std::string> data = files.all();
    const bool data_on_stdout = std::ranges::find(data, named_descriptor("-"), named_descriptor) != data.end();
    if (request.summary || !data_on_stdout) write_file(request.summary.value_or("-"), summary);
    say(recorded.recorder.warnings());
}

const Entry run_entry{"run",       "SCENE",  "physics only: CSV files and a summary as JSON",
                      run_options, read_run, scene_parameters_help};

}  // namespace pushfactor::demos::commands
