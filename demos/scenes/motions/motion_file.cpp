#include "demos/scenes/motions/motion_file.h"

#include "demos/scenes/vector_json.h"

#include <algorithm>

namespace pushfactor::demos {

namespace {

using engine::Vector3;

using Keys = std::vector<std::string>;
const Keys steady_keys{"velocity_m_per_s", "angular_velocity_rad_per_s"};
const Keys shaking_keys{"amplitude_m", "direction", "frequency_hz", "phase_deg"};
const Keys pose_keys{"time_s", "position_m", "orientation_wxyz"};

constexpr double latest = 1e9;  // s

Keys motion_keys() {
    Keys keys{"poses", "from_s", "until_s"};
    keys.insert(keys.end(), steady_keys.begin(), steady_keys.end());
    keys.insert(keys.end(), shaking_keys.begin(), shaking_keys.end());
    return keys;
}

bool has_any(const JsonReader& json, const Keys& keys) {
    return std::any_of(keys.begin(), keys.end(), [&](const std::string& key) { return json.has(key); });
}

void refuse_each(const JsonReader& json, const Keys& keys, const std::string& allowed) {
    for (const std::string& key : keys) {
        if (json.has(key)) json.at(key).refuse(allowed);
    }
}

SteadyMotion read_steady(const JsonReader& json) {
    SteadyMotion steady;
    if (json.has("velocity_m_per_s")) steady.velocity = json.at("velocity_m_per_s").vector();
    if (json.has("angular_velocity_rad_per_s"))
        steady.angular_velocity = json.at("angular_velocity_rad_per_s").vector();
    return steady;
}

ShakingMotion read_shaking(const JsonReader& json) {
    ShakingMotion shaking{.amplitude = json.at("amplitude_m").not_negative(),
                          .direction = json.at("direction").vector(),
                          .frequency = json.at("frequency_hz").positive()};
    const double length = shaking.direction.norm();
    if (!(length > 1e-100 && length < 1e100)) json.at("direction").refuse("a vector that has a direction");
    if (json.has("phase_deg")) shaking.phase = json.at("phase_deg").number(-360.0, 360.0);
    return shaking;
}

std::vector<TimedPose> read_poses(const JsonReader& json) {
    std::vector<TimedPose> poses;
    double before = 0.0;
    for (const JsonReader& entry : json.elements()) {
        entry.require_object(pose_keys);
        TimedPose pose{.time = entry.at("time_s").number(0.0, latest)};
        // Times closer together than that are one (path.h).
        if (!(pose.time > before + 1e-8 * before)) {
            entry.at("time_s").refuse(poses.empty() ? "above 0: the body's own pose is that at 0"
                                                    : "above that of the pose before");
        }
        if (entry.has("position_m")) pose.position = entry.at("position_m").vector();
        if (entry.has("orientation_wxyz")) pose.orientation = entry.at("orientation_wxyz").rotation();
        before = pose.time;
        poses.push_back(pose);
    }
    if (poses.empty()) json.refuse("one pose at least");
    return poses;
}

using demos::to_json;  // of a vector

Json to_json(const TimedPose& pose) {
    Json json{{"time_s", pose.time}};
    if (pose.position) json["position_m"] = to_json(*pose.position);
    if (pose.orientation) {
        const engine::Quaternion& q = *pose.orientation;
        json["orientation_wxyz"] = Json::array({q.w(), q.x(), q.y(), q.z()});
    }
    return json;
}

}  // namespace

MotionDescription read_motion(const JsonReader& json) {
    static const Keys known = motion_keys();
    json.require_object(known);
    MotionDescription motion;
    if (json.has("poses")) {
        refuse_each(json, steady_keys, "left out beside poses");
        refuse_each(json, shaking_keys, "left out beside poses");
        refuse_each(json, {"from_s", "until_s"}, "left out: each pose has its time_s");
        motion.kind = read_poses(json.at("poses"));
        return motion;
    }
    if (has_any(json, shaking_keys)) {
        refuse_each(json, steady_keys, "left out of a motion to and fro");
        motion.kind = read_shaking(json);
    } else if (has_any(json, steady_keys)) {
        motion.kind = read_steady(json);
    } else {
        json.refuse("given velocity_m_per_s, angular_velocity_rad_per_s, amplitude_m or poses");
    }
    if (json.has("from_s")) motion.from = json.at("from_s").number(0.0, latest);
    if (json.has("until_s")) motion.until = json.at("until_s").number(motion.from, latest);
    return motion;
}

Json motion_json(const MotionDescription& motion) {
    Json json = Json::object();
    std::visit(engine::Overloaded{[&](const SteadyMotion& steady) {
                                      json["velocity_m_per_s"] = to_json(steady.velocity);
                                      json["angular_velocity_rad_per_s"] = to_json(steady.angular_velocity);
                                  },
                                  [&](const ShakingMotion& shaking) {
                                      json["amplitude_m"] = shaking.amplitude;
                                      json["direction"] = to_json(shaking.direction);
                                      json["frequency_hz"] = shaking.frequency;
                                      json["phase_deg"] = shaking.phase;
                                  },
                                  [&](const std::vector<TimedPose>& poses) {
                                      for (const TimedPose& pose : poses) json["poses"].push_back(to_json(pose));
                                  }},
               motion.kind);
    if (motion.from != 0.0) json["from_s"] = motion.from;
    if (motion.until) json["until_s"] = *motion.until;
    return json;
}

const std::map<std::string, std::vector<std::string>>& motion_file_keys() {
    static const std::map<std::string, std::vector<std::string>> keys{{"motion", motion_keys()},
                                                                      {"pose", pose_keys}};
    return keys;
}

}  // namespace pushfactor::demos
