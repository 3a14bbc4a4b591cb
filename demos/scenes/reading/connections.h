// What acts on the bodies of a scene file: distances and springs, joints, forces.
#pragma once

#include "demos/scenes/reading/bodies.h"
#include "demos/scenes/scene_description.h"
#include "demos/text/json_reader.h"

#include <map>
#include <string>
#include <vector>

namespace pushfactor::demos {

// In the frames that the file speaks of, see to_body_frames().
DistanceDescription read_distance(const JsonReader& json, const BodyNames& names);
JointDescription read_joint(const JsonReader& json, const BodyNames& names);
ForceDescription read_force(const JsonReader& json, const BodyNames& names);

// The name of a body of the scene, or "world" if that is allowed.
std::string read_body_name(const JsonReader& json, const BodyNames& names, bool or_world);

// The keys of their objects, by object.
std::map<std::string, std::vector<std::string>> connection_keys();

}  // namespace pushfactor::demos
