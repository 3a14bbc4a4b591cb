// The lines of a trajectory as `--trajectory` writes them, one after the other.
#pragma once

#include "engine/base/math.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace pushfactor::demos {

// First columns of the file; others may follow, such as velocities.
inline constexpr const char* pose_columns = "time_s,body,x_m,y_m,z_m,qw,qx,qy,qz";

// The last column of a run's own: its motion_hash(). Files of earlier versions have none.
inline constexpr const char* hash_column = ",motion_hash";

// Where a body of the world is.
struct BodyPose {
    std::size_t body = 0;
    engine::Vector3 position = engine::Vector3::Zero();
    engine::Quaternion orientation = engine::Quaternion::Identity();
};

struct PoseLine {
    double time = 0.0;  // s
    BodyPose pose;
    std::string hash{};  // empty without the column
};

class PoseReader {
  public:
    // `option` begins all messages. Throws UsageError for a file that is no trajectory.
    PoseReader(std::string option, const std::filesystem::path& file);

    // Back to the first line.
    void rewind();

    // None at the end. Throws UsageError for a line that is none of a trajectory.
    std::optional<PoseLine> next();

    long line() const { return line_; }  // of the file, from 1: the last one read
    [[noreturn]] void refuse(const std::string& what) const;

  private:
    std::string name_;
    std::ifstream stream_;
    long line_ = 0;
    bool has_hash_ = false;
    std::string text_;
};

}  // namespace pushfactor::demos
