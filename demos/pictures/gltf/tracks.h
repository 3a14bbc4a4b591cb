// What moves in a run, frame by frame, as the floats that glTF stores.
#pragma once

#include "engine/base/math.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pushfactor::demos::pictures::gltf {

struct Pose {
    engine::Vector3 position = engine::Vector3::Zero();  // m
    engine::Quaternion orientation = engine::Quaternion::Identity();
};

// The shortest rotation of `from` to the direction of `to`; neither is zero. Eigen's own takes seconds to compile.
engine::Quaternion rotation_between(const engine::Vector3& from, const engine::Vector3& to);

struct Segment {
    engine::Vector3 from = engine::Vector3::Zero(), to = engine::Vector3::Zero();  // m

    bool operator==(const Segment&) const = default;
};

// A mark of a frame: an arrow, a line, or a point, which has two equal ends.
struct Mark {
    std::size_t kind = 0;
    Segment segment{};
};

// The values of an animation's keys, one after the other: x, y, z, or x, y, z, w of a unit quaternion.
using Values = std::vector<float>;

// The frames of a run: 28 bytes per pose and frame, 24 per segment and per mark.
class Tracks {
  public:
    // Adds a frame. Poses and segments: as many as in all other frames, in the same order.
    void add(std::span<const Pose> poses, std::span<const Segment> segments, std::span<const Mark> marks);

    std::size_t frames() const { return frames_.size(); }

    // Of pose `i`, a key per frame.
    Values positions(std::size_t i) const;
    // The same, with signs such that each quaternion is near the one before.
    Values orientations(std::size_t i) const;

    Segment segment(std::size_t frame, std::size_t i) const;
    // The `nth` mark of a kind; none if the frame has fewer.
    std::optional<Segment> mark(std::size_t frame, std::size_t kind, std::size_t nth) const;
    // The largest number of marks of a kind in a frame.
    std::size_t most_marks(std::size_t kind) const;

  private:
    struct Frame {
        std::vector<float> numbers;           // of poses, segments, and marks by kind
        std::vector<std::uint32_t> mark_end;  // per kind: number of marks of this and all lower kinds
    };

    std::size_t poses_ = 0, segments_ = 0;  // per frame
    std::vector<Frame> frames_;
};

// Whether all keys are equal.
bool is_constant(const Values& values, std::size_t numbers_per_key);

// How a mesh along the y axis is put between two points.
struct Stretch {
    enum class Origin { start, middle } origin = Origin::middle;  // of the mesh
    engine::Vector3 per_length = engine::Vector3::Zero();         // scale = this x length + `fixed`
    engine::Vector3 fixed = engine::Vector3::Zero();              // m
};

struct Stretched {
    Values translations, rotations, scales;
};

// A mesh between the points of each key. Its direction turns by the shortest way from key to key. Lengths that
// differ by less than a millionth count as equal. A key without points has scale 0 and stays where the mesh was.
Stretched stretched(std::span<const std::optional<Segment>> keys, const Stretch& how);

}  // namespace pushfactor::demos::pictures::gltf
