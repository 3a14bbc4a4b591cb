#include "demos/runs/recorder.h"

#include "demos/base/platform/output_file.h"
#include "demos/base/platform/version.h"
#include "demos/base/text/errors.h"
#include "demos/runs/summary.h"
#include "demos/scenes/scene_file.h"

#include <fmt/format.h>

namespace pushfactor::demos {

std::vector<std::string> RunFiles::all() const {
    std::vector<std::string> paths;
    for (const auto* const file : {&csv, &trajectory, &rows, &errors, &save_state, &glb, &replay}) {
        if (*file) paths.push_back(**file);
    }
    return paths;
}

Recorder::Recorder(const Session& session, const RunFiles& files, bool timing, std::filesystem::path folder)
    : session_(session), timing_(timing), folder_(std::move(folder)), save_state_(files.save_state) {
    const Simulation& run = session.run(0);
    for (std::size_t panel = 0; panel < session.size(); ++panel) {
        measurements_.emplace_back(session.run(panel), &files.measures);
    }
    if (files.csv) records_.push_back(steps_record(*files.csv, timing));
    if (files.trajectory) {
        const FrameChoices& frames = session.choices(0).frames;
        const long every = frames.fps ? steps_a_frame(*frames.fps, run.settings().dt, frames.play_speed) : 1;
        records_.push_back(trajectory_record(*files.trajectory, every, motion_hash(session.choices(0)), run));
    }
    if (files.rows) records_.push_back(rows_record(*files.rows));
    if (files.errors) {
        if (MeasuredErrors(run.scene()).empty()) {
            throw UsageError("--errors {}: must be of a scene with measured motion, as --measured gives",
                             *files.errors);
        }
        records_.push_back(errors_record(*files.errors, run));
    }
}

void Recorder::step(std::size_t panel) {
    const Simulation& run = session_.run(panel);
    measurements_[panel].observe(run);
    if (panel > 0) return;
    for (const auto& record : records_) record->observe(run);
    last_recorded_ = run.sample().step;
}

Choices Recorder::choices(std::size_t panel) const {
    return timing_ ? session_.choices(panel).on_one_thread() : session_.choices(panel);
}

std::string Recorder::state_text(std::size_t panel, const Checkpoint& checkpoint) const {
    return scene_file_text(resumed(spelled_out(choices(panel)), session_.run(panel).scene(), checkpoint));
}

std::string Recorder::failed(std::size_t panel) {
    const std::string stem = session_.choices(panel).description.name + "-last-good";
    try {
        const auto path =
            write_new_file(folder_, stem, ".json", state_text(panel, session_.run(panel).checkpoint_before()));
        return "; the state before that step is in " + path.string();
    } catch (const OutputError& error) {
        return std::string("; the state before that step could not be written: ") + error.what();
    }
}

std::vector<Json> Recorder::finish() {
    for (const auto& record : records_) record->finish();
    if (save_state_) write_file(*save_state_, state_text(0, session_.run(0).checkpoint()));
    std::vector<Json> summaries;
    for (std::size_t panel = 0; panel < session_.size(); ++panel) {
        summaries.push_back(summary_of(choices(panel), session_.run(panel), measurements_[panel]));
    }
    return summaries;
}

std::string Recorder::keep_records() {
    std::string text;
    for (const auto& record : records_) {
        text += kept(record->file_name(), fmt::format("step {}", last_recorded_), [&] { record->finish(); });
    }
    return text;
}

std::string Recorder::warnings() const {
    std::string text;
    for (std::size_t panel = 0; panel < session_.size(); ++panel) {
        const std::string &scene = session_.run(panel).scene().name,
                          &label = session_.sequence().panels[panel].label;
        text +=
            warning_text(label.empty() ? scene : scene + ", " + label, session_.run(panel), measurements_[panel]);
    }
    return text;
}

std::string summary_text(const Session& session, const std::vector<Json>& summaries, const std::string& driver) {
    Json summary;
    if (summaries.size() == 1) {
        summary = summaries.front();
    } else {
        summary["compare"] = session.choices(0).frames.compare->option;
        summary["panels"] = summaries;
    }
    summary["made_with"] = {{"program", version_text()}};
    if (!driver.empty()) summary["made_with"]["driver"] = driver;
    return json_text(summary);
}

}  // namespace pushfactor::demos
