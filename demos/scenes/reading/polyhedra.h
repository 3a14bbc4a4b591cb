// The polyhedra of a scene file, whose points are in a frame of their own choice.
#pragma once

#include "demos/scenes/polyhedron_shape.h"
#include "demos/scenes/scene_description.h"
#include "demos/text/json_reader.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pushfactor::demos {

// Each is made once: bodies with the same points share them.
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

// The polyhedron of a body, from its points or from the OBJ file that it names.
FramedPolyhedron read_polyhedron(const JsonReader& body, Polyhedra& polyhedra);

// From the frame of the points, which the file speaks of, to the body frame.
DistanceDescription to_body_frames(DistanceDescription distance, const Polyhedra& polyhedra);
JointDescription to_body_frames(JointDescription joint, const Polyhedra& polyhedra);
// `has_point`: the file says where the force acts.
ForceDescription to_body_frame(ForceDescription force, bool has_point, const Polyhedra& polyhedra);

}  // namespace pushfactor::demos
