#include "demos/pictures/gltf/tracks.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace pushfactor::demos::pictures::gltf {

namespace {

using engine::Quaternion;
using engine::Vector3;

constexpr std::size_t per_pose = 7, per_segment = 6;  // floats

// What has flown beyond a float's range stays at its end: the format has no infinite numbers.
void append(std::vector<float>& numbers, const Vector3& v) {
    constexpr double most = std::numeric_limits<float>::max();
    for (const double part : v) numbers.push_back(static_cast<float>(std::clamp(part, -most, most)));
}

// x, y, z, w
void append(std::vector<float>& numbers, const Quaternion& q) {
    for (const double part : q.coeffs()) numbers.push_back(static_cast<float>(part));
}

void append(std::vector<float>& numbers, const Segment& segment) {
    append(numbers, segment.from);
    append(numbers, segment.to);
}

Vector3 vector_at(const float* numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

Segment segment_at(const float* numbers) {
    return {vector_at(numbers), vector_at(numbers + 3)};
}

// Lengths that only rounding and the solver change would cost a channel.
bool all_alike(std::span<const std::optional<Segment>> keys) {
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (const auto& key : keys) {
        if (!key) return false;
        const double length = (key->to - key->from).norm();
        least = std::min(least, length);
        most = std::max(most, length);
    }
    return most - least <= 1e-6 * most;
}

}  // namespace

Quaternion rotation_between(const Vector3& from, const Vector3& to) {
    const Vector3 start = from.normalized(), end = to.normalized();
    const double twice_cosine = (start + end).norm();  // of half the angle
    // Opposite: half a turn about any axis across.
    if (twice_cosine < 1e-12) return Quaternion(Eigen::AngleAxisd(std::numbers::pi, start.unitOrthogonal()));
    Quaternion turn;
    turn.w() = 0.5 * twice_cosine;
    turn.vec() = start.cross(end) / twice_cosine;
    return turn;
}

void Tracks::add(std::span<const Pose> poses, std::span<const Segment> segments, std::span<const Mark> marks) {
    poses_ = poses.size();
    segments_ = segments.size();
    Frame frame;
    frame.numbers.reserve(per_pose * poses_ + per_segment * (segments_ + marks.size()));
    for (const Pose& pose : poses) {
        append(frame.numbers, pose.position);
        append(frame.numbers, pose.orientation);
    }
    for (const Segment& segment : segments) append(frame.numbers, segment);
    std::uint32_t count = 0;
    for (std::size_t kind = 0; count < marks.size(); ++kind) {
        for (const Mark& mark : marks) {
            if (mark.kind != kind) continue;
            append(frame.numbers, mark.segment);
            ++count;
        }
        frame.mark_end.push_back(count);
    }
    frames_.push_back(std::move(frame));
}

Values Tracks::positions(std::size_t i) const {
    Values values;
    values.reserve(3 * frames_.size());
    for (const Frame& frame : frames_) {
        const float* const first = &frame.numbers[per_pose * i];
        values.insert(values.end(), first, first + 3);
    }
    return values;
}

Values Tracks::orientations(std::size_t i) const {
    Values values;
    values.reserve(4 * frames_.size());
    for (const Frame& frame : frames_) {
        const float* const now = &frame.numbers[per_pose * i + 3];
        float along = 1.0f;
        if (!values.empty()) {
            const float* const before = &values[values.size() - 4];
            along = before[0] * now[0] + before[1] * now[1] + before[2] * now[2] + before[3] * now[3];
        }
        for (int part = 0; part < 4; ++part) values.push_back(along < 0.0f ? -now[part] : now[part]);
    }
    return values;
}

Segment Tracks::segment(std::size_t frame, std::size_t i) const {
    return segment_at(&frames_[frame].numbers[per_pose * poses_ + per_segment * i]);
}

std::optional<Segment> Tracks::mark(std::size_t frame, std::size_t kind, std::size_t nth) const {
    const Frame& at = frames_[frame];
    if (kind >= at.mark_end.size()) return std::nullopt;
    const std::size_t index = (kind > 0 ? at.mark_end[kind - 1] : 0) + nth;
    if (index >= at.mark_end[kind]) return std::nullopt;
    return segment_at(&at.numbers[per_pose * poses_ + per_segment * (segments_ + index)]);
}

std::size_t Tracks::most_marks(std::size_t kind) const {
    std::size_t most = 0;
    for (const Frame& frame : frames_) {
        if (kind >= frame.mark_end.size()) continue;
        most = std::max<std::size_t>(most, frame.mark_end[kind] - (kind > 0 ? frame.mark_end[kind - 1] : 0));
    }
    return most;
}

bool is_constant(const Values& values, std::size_t numbers_per_key) {
    return std::equal(values.begin() + static_cast<std::ptrdiff_t>(std::min(numbers_per_key, values.size())),
                      values.end(), values.begin());
}

Stretched stretched(std::span<const std::optional<Segment>> keys, const Stretch& how) {
    Stretched result;
    const bool alike = all_alike(keys);
    const auto first = std::ranges::find_if(keys, [](const auto& key) { return key.has_value(); });
    Segment last = first == keys.end() ? Segment{} : **first;
    const double usual = (last.to - last.from).norm();
    Vector3 direction = Vector3::UnitY();
    Quaternion rotation = Quaternion::Identity();
    for (const std::optional<Segment>& key : keys) {
        if (key) last = *key;
        const Vector3 along = last.to - last.from;
        const double length = along.norm();
        if (length > 0.0) {
            rotation = (rotation_between(direction, along) * rotation).normalized();
            direction = along / length;
        }
        const bool from_start = how.origin == Stretch::Origin::start;
        append(result.translations, from_start ? last.from : Vector3(0.5 * (last.from + last.to)));
        append(result.rotations, rotation);
        const Vector3 scale = how.per_length * (alike ? usual : length) + how.fixed;
        append(result.scales, key ? scale : Vector3(Vector3::Zero()));
    }
    return result;
}

}  // namespace pushfactor::demos::pictures::gltf
