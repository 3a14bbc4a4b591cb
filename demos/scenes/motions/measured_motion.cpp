#include "demos/scenes/motions/measured_motion.h"

#include "engine/base/overloaded.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace pushfactor::demos {

namespace {

using engine::Vector3;

constexpr double smaller = 0.98;

// The shape of `of`; that of a polyhedron may have another frame, which the poses of `body` then follow.
void give_shape(BodyDescription& body, const BodyDescription& of) {
    std::visit(
        engine::Overloaded{[&](const BoxShape& box) { body.shape = BoxShape{smaller * box.size}; },
                           [&](const SphereShape& sphere) { body.shape = SphereShape{smaller * sphere.radius}; },
                           [&](const PlaneShape& plane) { body.shape = plane; },
                           [&](const PolyhedronShape& polyhedron) {
                               std::vector<Vector3> points;
                               for (const Vector3& point : polyhedron.points()) points.push_back(smaller * point);
                               give_polyhedron(body, make_polyhedron(points));
                           }},
        of.shape);
}

}  // namespace

void add_measured(SceneDescription& scene, std::size_t body, const std::vector<PoseLine>& poses) {
    const BodyDescription& of = scene.bodies[body];
    std::vector<TimedPose> motion;
    for (std::size_t i = 1; i < poses.size(); ++i) {
        motion.push_back({poses[i].time, poses[i].pose.position, poses[i].pose.orientation});
    }
    BodyDescription measured;
    measured.name = "measured " + of.name;
    measured.motion = MotionDescription{.kind = motion};
    measured.position = poses.front().pose.position;
    measured.orientation = poses.front().pose.orientation;
    measured.colour = "ivory";
    measured.measured_of = of.name;
    give_shape(measured, of);
    scene.bodies.push_back(std::move(measured));
}

void add_measured(SceneDescription& scene, const std::filesystem::path& file) {
    PoseReader reader("--measured ", file);
    std::map<std::size_t, std::vector<PoseLine>> by_body;
    const std::size_t count = scene.bodies.size();
    while (const auto line = reader.next()) {
        const std::size_t number = line->pose.body;
        const auto refuse = [&](const std::string& what) {
            reader.refuse(fmt::format("line {}: {}", reader.line(), what));
        };
        if (number >= count) refuse(fmt::format("body {} must be one of the scene's, 0 to {}", number, count - 1));
        const BodyDescription& body = scene.bodies[number];
        if (!body.mass) {
            if (!body.motion) refuse(fmt::format("body {} ({}) must be one with a mass", number, body.name));
            continue;
        }
        std::vector<PoseLine>& poses = by_body[number];
        if (poses.empty() && line->time != 0.0) {
            refuse(fmt::format("body {} ({}) must begin at 0 s, not {}", number, body.name, line->time));
        }
        // Times closer together than that are one (path.h).
        if (!poses.empty() && !(line->time > poses.back().time + 1e-8 * poses.back().time)) {
            refuse(
                fmt::format("the time of body {} ({}) must be above that of its line before", number, body.name));
        }
        poses.push_back(*line);
    }
    if (by_body.empty()) reader.refuse("must have poses of a body with a mass");
    for (const auto& [number, poses] : by_body) {
        const std::string& name = scene.bodies[number].name;
        if (poses.size() < 2) reader.refuse(fmt::format("body {} ({}) must have two poses at least", number, name));
        if (std::ranges::find(scene.bodies, "measured " + name, &BodyDescription::name) != scene.bodies.end()) {
            reader.refuse(fmt::format("must be left out of a scene that has a body \"measured {}\"", name));
        }
        add_measured(scene, number, poses);
    }
}

}  // namespace pushfactor::demos
