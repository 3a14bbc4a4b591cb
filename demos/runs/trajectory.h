// Poses of a run as `--trajectory` wrote them, for pictures of a run without running it again.
#pragma once

#include "demos/runs/simulation.h"
#include "demos/scenes/motions/pose_reader.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace pushfactor::demos {

// Whether the file has lines for this body of the world: it can move, or is moved.
bool is_recorded(const BuiltScene& scene, std::size_t body);

class Trajectory {
  public:
    // Throws UsageError for a file that is no trajectory, or of a run with another motion_hash() than `hash`.
    Trajectory(const std::filesystem::path& file, std::uint32_t hash);

    // Places the bodies of a run, which must not be advanced any more, as they were after this step. Reads on from
    // the last place, or from the start for an earlier step. Numbers are exact, so that pictures are the same as of
    // the run itself. Throws UsageError if the file has no such instant, or, at the start, other bodies than the
    // run.
    void place(Simulation& simulation, long step);

  private:
    std::vector<BodyPose> poses_at(double time);

    PoseReader reader_;
    std::optional<PoseLine> next_;
    long placed_ = -1;  // step
};

}  // namespace pushfactor::demos
