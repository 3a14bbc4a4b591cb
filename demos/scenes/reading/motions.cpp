// The motion of a moved body.
#include "demos/scenes/reading/parts.h"

namespace pushfactor::demos {

namespace {

constexpr double latest = 1e9;  // s

engine::Vector3 read_direction(const JsonReader& json) {
    const engine::Vector3 direction = json.vector();
    const double length = direction.norm();
    if (!(length > 1e-100 && length < 1e100)) json.refuse("a vector that has a direction");
    return direction;
}

}  // namespace

void describe(Fields& fields, SteadyMotion& steady) {
    fields.may("velocity_m_per_s", steady.velocity, &JsonReader::vector);
    fields.may("angular_velocity_rad_per_s", steady.angular_velocity, &JsonReader::vector);
}

void describe(Fields& fields, ShakingMotion& shaking) {
    fields.must("amplitude_m", shaking.amplitude, &JsonReader::not_negative);
    fields.must("direction", shaking.direction, read_direction);
    fields.must("frequency_hz", shaking.frequency, &JsonReader::positive);
    fields.may("phase_deg", shaking.phase, between(-360.0, 360.0));
}

void describe(Fields& fields, TimedPose& pose) {
    fields.must("time_s", pose.time, between(0.0, latest));
    fields.if_any("position_m", pose.position, &JsonReader::vector);
    fields.if_any("orientation_wxyz", pose.orientation, &JsonReader::rotation);
}

namespace {

std::vector<TimedPose> read_poses(const JsonReader& json) {
    std::vector<TimedPose> poses;
    double before = 0.0;
    for (const JsonReader& entry : json.elements()) {
        poses.push_back(read_object<TimedPose>(entry));
        const double time = poses.back().time;
        // Times closer together than that are one (path.h).
        if (!(time > before + 1e-8 * before)) {
            entry.at("time_s").refuse(poses.size() == 1 ? "above 0: the body's own pose is that at 0"
                                                        : "above that of the pose before");
        }
        before = time;
    }
    if (poses.empty()) json.refuse("one pose at least");
    return poses;
}

bool has_any(const JsonReader& json, const Keys& keys) {
    return std::any_of(keys.begin(), keys.end(), [&](const std::string& key) { return json.has(key); });
}

Keys motion_keys() {
    return joined({{"poses", "from_s", "until_s"}, keys_of<SteadyMotion>(), keys_of<ShakingMotion>()});
}

}  // namespace

void describe(Fields& fields, std::vector<TimedPose>& poses) {
    fields.must("poses", poses, read_poses);
}

void describe(Fields& fields, MotionDescription& motion) {
    std::visit([&](auto& kind) { describe(fields, kind); }, motion.kind);
    fields.if_any("from_s", motion.from, between(0.0, latest));
    fields.if_any("until_s", motion.until, between(motion.from, latest));
}

MotionDescription read_motion(const JsonReader& json) {
    static const Keys known = motion_keys();
    const Keys &steady = keys_of<SteadyMotion>(), &shaking = keys_of<ShakingMotion>();
    json.require_object(known);
    MotionDescription motion;
    if (json.has("poses")) {
        refuse_if_given(json, steady, "left out beside poses");
        refuse_if_given(json, shaking, "left out beside poses");
        refuse_if_given(json, {"from_s", "until_s"}, "left out: each pose has its time_s");
        motion.kind = std::vector<TimedPose>();
    } else if (has_any(json, shaking)) {
        refuse_if_given(json, steady, "left out of a motion to and fro");
        motion.kind = ShakingMotion{};
    } else if (!has_any(json, steady)) {
        json.refuse("given velocity_m_per_s, angular_velocity_rad_per_s, amplitude_m or poses");
    }
    Fields fields(json);
    describe(fields, motion);
    return motion;
}

KeysByObject motion_file_keys() {
    return {{"motion", motion_keys()}, {"pose", keys_of<TimedPose>()}};
}

}  // namespace pushfactor::demos
