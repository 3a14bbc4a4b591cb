#include "demos/pictures/recorded_session.h"

#include "demos/base/platform/messages.h"
#include "demos/base/text/errors.h"
#include "demos/pictures/gltf/glb_record.h"

namespace pushfactor::demos::pictures {

RecordedSession::RecordedSession(const Sequence& sequence, const RunFiles& files, bool timing,
                                 std::filesystem::path folder, SurveyOnce& survey, std::vector<BuiltScene> built)
    : session(sequence, timing, {}, std::move(built)), recorder(session, files, timing, std::move(folder)) {
    if (files.glb) recorder.add(glb_record(*files.glb, sequence.panels, survey, session.run(0)));
    if (!files.replay) return;
    replay.emplace(
        ReplayChoices{.file = *files.replay, .poses_only = files.replay_poses_only, .command = files.command},
        session);
}

void RecordedSession::play(const std::function<void()>& work) {
    try {
        work();
    } catch (const OutputError&) {
        throw;
    } catch (const std::exception& error) {
        say(recorder.keep_records() + (replay ? replay->keep(error.what()) : "") + recorder.warnings());
        throw;
    }
}

std::vector<Json> RecordedSession::finish() {
    if (replay) replay->finish();
    return recorder.finish();
}

}  // namespace pushfactor::demos::pictures
