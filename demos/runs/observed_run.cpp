#include "demos/runs/observed_run.h"

#include "demos/platform/cpu_clock.h"
#include "demos/platform/output_file.h"
#include "demos/runs/summary.h"
#include "demos/runs/warnings.h"
#include "demos/scenes/scene_file.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

namespace pushfactor::demos {

namespace {

std::string state_text(const Choices& choices, const Simulation& simulation, const Checkpoint& checkpoint) {
    return scene_file_text(resumed(spelled_out(choices), simulation.scene(), checkpoint));
}

}  // namespace

ObservedRun::ObservedRun(const Choices& choices, const RunFiles& files, bool timing, std::filesystem::path folder)
    : choices_(timing ? choices.on_one_thread() : choices),
      simulation_(choices_, timing ? thread_cpu_us : nullptr),
      measurements_(simulation_, &files.measures),
      folder_(std::move(folder)),
      save_state_(files.save_state) {
    if (files.csv) records_.push_back(steps_record(*files.csv, timing));
    if (files.trajectory) {
        const auto& fps = choices.frames.fps;
        const long every = fps ? steps_a_frame(*fps, choices.settings.dt, choices.frames.play_speed) : 1;
        records_.push_back(trajectory_record(*files.trajectory, every, simulation_));
    }
    if (files.rows) records_.push_back(rows_record(*files.rows));
    if (files.errors) {
        if (MeasuredErrors(simulation_.scene()).empty()) {
            throw UsageError(fmt::format(
                "--errors {}: must be of a scene with measured motion, as --measured gives", *files.errors));
        }
        records_.push_back(errors_record(*files.errors, simulation_));
    }
}

void ObservedRun::advance() {
    try {
        simulation_.advance();
    } catch (const NonFiniteError& error) {
        throw NonFiniteError(fmt::format("{}; {}", error.what(), save_last_good()));
    }
    measurements_.observe(simulation_);
    for (const auto& record : records_) record->observe(simulation_);
    last_recorded_ = simulation_.sample().step;
}

std::string ObservedRun::save_last_good() const {
    const std::string stem = choices_.description.name + "-last-good";
    try {
        const auto path = write_new_file(folder_, stem, ".json",
                                         state_text(choices_, simulation_, simulation_.checkpoint_before()));
        return "the state before that step is in " + path.string();
    } catch (const OutputError& error) {
        return std::string("the state before that step could not be written: ") + error.what();
    }
}

std::string ObservedRun::finish() {
    for (const auto& record : records_) record->finish();
    if (save_state_) write_file(*save_state_, state_text(choices_, simulation_, simulation_.checkpoint()));
    return summary_text(choices_, simulation_, measurements_);
}

std::string ObservedRun::keep_records() {
    std::string text;
    for (const auto& record : records_) {
        try {
            record->finish();
            text += fmt::format("pushfactor: note: {} holds the run up to step {}, where it stopped\n",
                                record->file_name(), last_recorded_);
        } catch (const OutputError& error) {
            text += fmt::format("pushfactor: note: {}\n", error.what());
        }
    }
    return text;
}

std::string ObservedRun::warnings(const std::string& panel) const {
    const std::string& scene = simulation_.scene().name;
    return warning_text(panel.empty() ? scene : scene + ", " + panel, simulation_, measurements_);
}

}  // namespace pushfactor::demos
