#include "demos/scenes/reading/polyhedra.h"

#include "demos/scenes/convex_hull.h"
#include "demos/scenes/obj_file.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

#include <array>

namespace pushfactor::demos {

namespace {

using engine::Vector3;

void to_body_frame(DistanceDescription::End& end, const Polyhedra& polyhedra) {
    if (const FramedPolyhedron* const polyhedron = polyhedra.of(end.body))
        end.point = polyhedron->to_body(end.point);
}

std::vector<Vector3> read_points(const JsonReader& json) {
    std::vector<Vector3> points;
    std::map<std::array<double, 3>, std::size_t> known;
    for (const JsonReader& element : json.elements()) {
        const Vector3 point = element.vector();
        const auto [at, is_new] = known.emplace(std::array{point.x(), point.y(), point.z()}, points.size());
        if (!is_new) element.refuse(fmt::format("another point than number {}", at->second));
        points.push_back(point);
    }
    return points;
}

std::vector<Vector3> read_obj(const JsonReader& json, const std::filesystem::path& folder) {
    std::string fault;
    try {
        return read_obj_points(folder / json.string());
    } catch (const engine::InvalidInput& problem) {
        fault = problem.what();
    } catch (const UsageError& problem) {
        fault = problem.what();
    }
    json.refuse("a Wavefront OBJ file with vertices, by its path from the folder of this file; " + fault);
}

}  // namespace

FramedPolyhedron read_polyhedron(const JsonReader& body, Polyhedra& polyhedra) {
    if (body.has("obj_file") && body.has("points_m"))
        body.at("points_m").refuse("left out where obj_file is given");
    const JsonReader source = body.at(body.has("obj_file") ? "obj_file" : "points_m");
    const std::vector<Vector3> points =
        body.has("obj_file") ? read_obj(source, polyhedra.folder) : read_points(source);
    std::vector<double> key;
    for (const Vector3& point : points) key.insert(key.end(), point.begin(), point.end());
    const auto known = polyhedra.by_points.find(key);
    if (known != polyhedra.by_points.end()) return known->second;
    try {
        return polyhedra.by_points[key] = make_polyhedron(points);
    } catch (const NoPolyhedron& found) {
        source.refuse(fmt::format("{}, and these are {}", found.allowed, found.found));
    }
}

DistanceDescription to_body_frames(DistanceDescription distance, const Polyhedra& polyhedra) {
    to_body_frame(distance.a, polyhedra);
    to_body_frame(distance.b, polyhedra);
    return distance;
}

JointDescription to_body_frames(JointDescription joint, const Polyhedra& polyhedra) {
    to_body_frame(joint.a, polyhedra);
    to_body_frame(joint.b, polyhedra);
    if (!joint.hinge) return joint;
    if (const FramedPolyhedron* const a = polyhedra.of(joint.a.body)) {
        joint.hinge->axis = a->axes.conjugate() * joint.hinge->axis;
        if (joint.hinge->zero) joint.hinge->zero = a->axes.conjugate() * *joint.hinge->zero;
    }
    const FramedPolyhedron* const b = polyhedra.of(joint.b.body);
    if (b && joint.hinge->zero) joint.hinge->zero = *joint.hinge->zero * b->axes;
    return joint;
}

ForceDescription to_body_frame(ForceDescription force, bool has_point, const Polyhedra& polyhedra) {
    const FramedPolyhedron* const polyhedron = polyhedra.of(force.body);
    if (!polyhedron) return force;
    // Without a point a force acts at the centre of mass.
    if (has_point) force.point = polyhedron->to_body(force.point);
    if (force.frame == engine::Poke::Frame::body) {
        force.force = polyhedron->axes.conjugate() * force.force;
        force.torque = polyhedron->axes.conjugate() * force.torque;
    }
    return force;
}

}  // namespace pushfactor::demos
