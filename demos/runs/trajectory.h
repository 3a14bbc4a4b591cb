// Poses of a run as `--trajectory` wrote them, for pictures of a run without running it again.
#pragma once

#include "demos/runs/simulation.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace pushfactor::demos {

// First columns of the file; the others are velocities.
inline constexpr const char* pose_columns = "time_s,body,x_m,y_m,z_m,qw,qx,qy,qz";

// Whether the file has lines for this body of the world: it can move, or is moved.
bool is_recorded(const BuiltScene& scene, std::size_t body);

class Trajectory {
  public:
    // Throws UsageError for a file that is no trajectory.
    explicit Trajectory(std::filesystem::path file);

    // Places the bodies of a run, which must not be advanced any more, as they were after this step. Reads on from
    // the last place, or from the start for an earlier step. Numbers are exact, so that pictures are the same as of
    // the run itself. Throws UsageError if the file has no such instant, or, at the start, other bodies than the
    // run.
    void place(Simulation& simulation, long step);

  private:
    struct Line {
        double time = 0.0;  // s
        BodyPose pose;
    };

    void rewind();
    bool read_line();
    [[noreturn]] void refuse(const std::string& what) const;
    std::vector<BodyPose> poses_at(double time);

    std::string name_;
    std::ifstream stream_;
    Line next_;
    bool has_next_ = false;
    long lines_ = 0;
    long placed_ = -1;  // step
    std::string text_;
};

}  // namespace pushfactor::demos
