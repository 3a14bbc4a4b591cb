// A session with all files that are made of its runs.
#pragma once

#include "demos/pictures/camera/survey.h"
#include "demos/pictures/replay/replay.h"
#include "demos/runs/recorder.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace pushfactor::demos::pictures {

struct RecordedSession {
    RecordedSession(const Sequence& sequence, const RunFiles& files, bool timing, std::filesystem::path folder,
                    SurveyOnce& survey, std::vector<BuiltScene> built = {});

    // Does what plays the session. If something stops it, the files keep the steps so far.
    void play(const std::function<void()>& work);

    // Completes the files and returns the summaries of the runs.
    std::vector<Json> finish();

    Session session;
    Recorder recorder;
    std::optional<Replay> replay{};
};

}  // namespace pushfactor::demos::pictures
