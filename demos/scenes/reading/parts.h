// The parts of a scene file. Internal to scene_file.cpp and this folder.
#pragma once

#include "demos/scenes/reading/fields.h"
#include "demos/scenes/run_state.h"
#include "demos/scenes/scene_description.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pushfactor::demos {

// All bodies so far by name, and whether they are static; constraints and forces look theirs up.
using BodyNames = std::map<std::string, bool, std::less<>>;

// The polyhedra of a file, whose points are in a frame of its own choice. Each is made once: bodies with the same
// points share them.
struct Polyhedra {
    std::filesystem::path folder;  // of the scene file
    std::map<std::vector<double>, FramedPolyhedron> by_points{};
    std::map<std::string, FramedPolyhedron> by_body{};

    // Null for a body that is none.
    const FramedPolyhedron* of(const std::string& body) const {
        const auto found = by_body.find(body);
        return found == by_body.end() ? nullptr : &found->second;
    }
};

// Keys by object; the schema must know the same.
using KeysByObject = std::map<std::string, Keys>;

std::vector<BodyDescription> read_bodies(const JsonReader& json, BodyNames& names, Polyhedra& polyhedra);
Json to_json(const BodyDescription& body);
void describe(Fields& fields, BodyDescription& body);  // all but name, shape and mass
const Keys& body_keys();

MotionDescription read_motion(const JsonReader& json);
void describe(Fields& fields, MotionDescription& motion);
KeysByObject motion_file_keys();

// The polyhedron of a body, from its points or from the OBJ file that it names.
FramedPolyhedron read_polyhedron(const JsonReader& body, Polyhedra& polyhedra);

// Distances and springs, joints, forces: in body frames.
DistanceDescription read_distance(const JsonReader& json, const BodyNames& names, const Polyhedra& polyhedra);
JointDescription read_joint(const JsonReader& json, const BodyNames& names, const Polyhedra& polyhedra);
ForceDescription read_force(const JsonReader& json, const BodyNames& names, const Polyhedra& polyhedra);
void describe(Fields& fields, DistanceDescription& distance);
void describe(Fields& fields, JointDescription& joint);
void describe(Fields& fields, ForceDescription& force);
KeysByObject connection_keys();

// The name of a body of the scene, or "world" if that is allowed.
std::string read_body_name(const JsonReader& json, const BodyNames& names, bool or_world);

// The state of a run of `scene`, whose bodies and distances have been read. Written and read back, it is the same
// state, number for number.
RunState read_state(const JsonReader& json, const SceneDescription& scene);
Json state_json(const RunState& state, const SceneDescription& scene);
KeysByObject state_keys();

}  // namespace pushfactor::demos
