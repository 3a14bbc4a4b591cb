// The measurements and files of a session.
#pragma once

#include "demos/base/text/json.h"
#include "demos/runs/measurements.h"
#include "demos/runs/records.h"
#include "demos/runs/session.h"

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos {

// What a run writes: files written step by step, the final state, and measures that are not always made. Paths; "-"
// is standard output. The Recorder makes neither glb nor replay (pictures/recorded_session.h).
struct RunFiles {
    std::optional<std::string> csv, trajectory, rows, errors, save_state, glb, replay;
    bool replay_poses_only = false;
    std::string command;                // that makes them, as the reader of a replay sees it
    std::vector<std::string> measures;  // of the scene, which the summary is to have although they cost time

    bool operator==(const RunFiles&) const = default;

    // The paths of those that are written.
    std::vector<std::string> all() const;
};

class Recorder : public Observer {
  public:
    // `session` is at its start and must outlive it. With `timing` the CPU time is a column of the CSV file.
    // `folder` receives the last good state of a run that becomes non-finite. Files are those of a single run.
    Recorder(const Session& session, const RunFiles& files, bool timing, std::filesystem::path folder);

    // Adds a file that is written step by step, like the CSV files. Only before the first step.
    void add(std::unique_ptr<Record> record) { records_.push_back(std::move(record)); }

    void step(std::size_t panel) override;

    // Writes the state before the step as a scene file that fails in its first step.
    std::string failed(std::size_t panel) override;

    // Completes the files and returns the summaries of the runs.
    std::vector<Json> finish();

    // Completes the files of a session that stopped early, with the steps so far. Returns a note per file, or the
    // reason why it could not be written. Throws nothing.
    std::string keep_records();

    // One per line; empty if there are none.
    std::string warnings() const;

  private:
    Choices choices(std::size_t panel) const;
    std::string state_text(std::size_t panel, const Checkpoint& checkpoint) const;

    const Session& session_;
    bool timing_;
    std::deque<Measurements> measurements_;  // per run
    std::vector<std::unique_ptr<Record>> records_;
    std::filesystem::path folder_;
    std::optional<std::string> save_state_;
    long last_recorded_ = 0;  // step; a non-finite one is not recorded
};

// The summary of a session as the text of a file, with program and driver: what drew (OffscreenRenderer::driver()),
// empty if nothing was drawn.
std::string summary_text(const Session& session, const std::vector<Json>& summaries, const std::string& driver);

}  // namespace pushfactor::demos
