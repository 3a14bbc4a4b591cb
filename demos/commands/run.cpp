#include "demos/commands/commands.h"
#include "demos/pictures/gltf/glb_record.h"
#include "demos/pictures/overview.h"
#include "demos/pictures/replay/replay.h"
#include "demos/platform/output_file.h"
#include "demos/platform/progress.h"
#include "demos/runs/observed_run.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos::commands {

namespace {

std::vector<std::optional<std::string>> data_files(const Request& request) {
    const RunFiles& files = request.files;
    return {files.csv, files.trajectory, files.rows, files.save_state, request.glb, request.replay};
}

// Folder of the first output file; the working folder without one.
std::filesystem::path folder_of_outputs(const Request& request) {
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
        fmt::print(stderr, "{}{}{}", observed.keep_records(), replay ? replay->keep(error.what()) : "",
                   observed.warnings());
        throw;
    }
}

// What only a picture uses must not be ignored; a config file may have it for render.
void refuse_unused(const Request& request) {
    if (request.glb || request.replay) return;
    for (const char* const name : {"camera", "overlay"}) {
        const auto* const given = request.given.find(name);
        if (!given || !given->field.starts_with("--")) continue;
        throw UsageError(fmt::format("{} {}: must come with --glb or --replay", given->field, given->text));
    }
}

}  // namespace

void run(const Request& request) {
    refuse_unused(request);
    std::vector<ComparedRun> runs{{.label = "", .choices = understand(request.scenes.front(), request.given)}};
    const Choices& choices = runs.front().choices;
    const long steps = whole_steps(choices.settings);
    if (request.replay) pictures::check_replay_name(*request.replay);
    const long every = request.replay ? pictures::steps_a_replay_frame(choices) : 1;
    std::vector<std::vector<Frame>> frames;
    if (request.glb) {
        pictures::check_glb(*request.glb, choices);
        frames.push_back(plan_frames(choices.frames, choices.settings.dt, steps));
        pictures::add_overview(runs, frames);
    }
    ObservedRun observed(choices, request.files, request.timing, folder_of_outputs(request));
    if (request.glb) {
        const bool needed = pictures::needs_survey(choices.frames);
        const pictures::Survey survey = needed ? pictures::survey(runs, frames) : pictures::Survey{};
        observed.add(pictures::glb_record(*request.glb, choices, survey, observed.simulation()));
    }
    std::optional<pictures::Replay> replay;
    if (request.replay) {
        replay.emplace(pictures::ReplayChoices{.file = *request.replay,
                                               .steps_a_frame = every,
                                               .poses_only = request.replay_poses_only,
                                               .command = request.command_line},
                       runs, std::vector{&observed.simulation()});
    }
    go_through(observed, choices.description.name, steps, replay ? &*replay : nullptr, every);
    if (replay) replay->finish();
    const std::string summary = observed.finish();
    const std::vector<std::optional<std::string>> data = data_files(request);
    const bool data_on_stdout = std::find(data.begin(), data.end(), "-") != data.end();
    if (request.summary || !data_on_stdout) write_file(request.summary.value_or("-"), summary);
    fmt::print(stderr, "{}", observed.warnings());
}

}  // namespace pushfactor::demos::commands
