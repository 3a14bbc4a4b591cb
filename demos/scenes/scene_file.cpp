#include "demos/scenes/scene_file.h"

#include "demos/scenes/camera_file.h"
#include "demos/scenes/convex_hull.h"
#include "demos/scenes/motion_file.h"
#include "demos/scenes/obj_file.h"
#include "demos/scenes/scene_file_words.h"
#include "demos/scenes/state_file.h"
#include "demos/text/errors.h"
#include "demos/text/json_file.h"
#include "demos/text/json_reader.h"
#include "demos/text/palette.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace pushfactor::demos {

namespace {

using engine::Vector3;

constexpr std::size_t most_bodies = 100000;

using Keys = std::vector<std::string>;
const Keys scene_keys{"version", "name",    "gravity_m_per_s2", "bodies",      "distance_constraints",
                      "joints",  "forces",  "contacts",         "no_contacts", "material_pairs",
                      "state",   "options", "camera",           "colours"};
const Keys body_keys{"name",
                     "shape",
                     "size_m",
                     "radius_m",
                     "points_m",
                     "obj_file",
                     "mass_kg",
                     "density_kg_per_m3",
                     "static",
                     "motion",
                     "position_m",
                     "orientation_wxyz",
                     "velocity_m_per_s",
                     "angular_velocity_rad_per_s",
                     "linear_momentum_kg_m_per_s",
                     "angular_momentum_kg_m2_per_s",
                     "friction",
                     "restitution",
                     "material",
                     "group",
                     "surface_velocity_m_per_s",
                     "surface_from_s"};
const Keys distance_keys{"a", "b", "length_m", "acts", "max_force_n", "spring"};
const Keys spring_keys{"stiffness_n_per_m", "damping_n_s_per_m"};
const Keys joint_keys{"type", "a", "b", "axis", "zero_wxyz", "motor", "limits_rad", "collide"};
const Keys motor_keys{"speed_rad_per_s", "max_torque_n_m"};
const Keys end_keys{"body", "point_m"};
const Keys force_keys{"body", "force_n", "torque_n_m", "point_m", "frame", "from_s", "until_s"};
const Keys material_pair_keys{"a", "b", "friction", "restitution"};

double read_length(const JsonReader& json) {
    return json.number(engine::least_length, engine::greatest_length);
}

// The polyhedra of a file, each made once: bodies with the same points share them.
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

// From the frame of the points, which the file speaks of, to the body frame.
void to_body_frame(DistanceDescription::End& end, const Polyhedra& polyhedra) {
    if (const FramedPolyhedron* const polyhedron = polyhedra.of(end.body))
        end.point = polyhedron->to_body(end.point);
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
    try {
        return read_obj_points(folder / json.string());
    } catch (const engine::InvalidInput&) {
        json.refuse("a Wavefront OBJ file with vertices, by its path from the folder of this file");
    }
}

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

decltype(BodyDescription::shape) read_shape(const JsonReader& body) {
    const JsonReader shape = body.at("shape");
    const std::string name = shape.string();
    if (name == "plane") return PlaneShape{};
    if (name == "polyhedron") return PolyhedronShape{};  // read_body() gives it its points
    if (name == "sphere") return SphereShape{read_length(body.at("radius_m"))};
    if (name != "box") shape.refuse("one of box, sphere, plane, polyhedron");
    const JsonReader size = body.at("size_m");
    const std::vector<JsonReader> edges = size.elements();
    if (edges.size() != 3) size.refuse("three numbers [x, y, z]");
    return BoxShape{{read_length(edges[0]), read_length(edges[1]), read_length(edges[2])}};
}

void refuse_if_given(const JsonReader& json, std::initializer_list<const char*> keys, const std::string& allowed) {
    for (const char* key : keys) {
        if (json.has(key)) json.at(key).refuse(allowed);
    }
}

// A key that would be ignored is refused: it was meant for something.
void refuse_foreign_keys(const JsonReader& json, const BodyDescription& body, bool fixed) {
    const bool plane = std::holds_alternative<PlaneShape>(body.shape);
    std::visit(
        engine::Overloaded{
            [&](const BoxShape&) {
                refuse_if_given(json, {"radius_m", "points_m", "obj_file"}, "left out: a box has size_m");
            },
            [&](const SphereShape&) {
                refuse_if_given(json, {"size_m", "points_m", "obj_file"}, "left out: a sphere has radius_m");
            },
            [&](const PlaneShape&) {
                refuse_if_given(json, {"size_m", "radius_m", "points_m", "obj_file"},
                                "left out: a plane has no size");
            },
            [&](const PolyhedronShape&) {
                refuse_if_given(json, {"size_m", "radius_m"}, "left out: a polyhedron has points_m or obj_file");
            }},
        body.shape);
    if (plane) refuse_if_given(json, {"mass_kg", "density_kg_per_m3"}, "left out: a plane is static");
    if (json.has("mass_kg")) {
        refuse_if_given(json, {"density_kg_per_m3"}, "left out where mass_kg is given");
    }
    if (plane || fixed) {
        refuse_if_given(json,
                        {"mass_kg", "density_kg_per_m3", "velocity_m_per_s", "angular_velocity_rad_per_s",
                         "linear_momentum_kg_m_per_s", "angular_momentum_kg_m2_per_s"},
                        "left out of a static body");
    }
    if (json.has("linear_momentum_kg_m_per_s")) {
        refuse_if_given(json, {"velocity_m_per_s"}, "left out where the momentum is given");
    }
    if (json.has("angular_momentum_kg_m2_per_s")) {
        refuse_if_given(json, {"angular_velocity_rad_per_s"}, "left out where the momentum is given");
    }
}

std::string read_name(const JsonReader& json) {
    std::string name = json.string();
    if (name.empty()) json.refuse("a name of at least one letter");
    return name;
}

// The value that `names` give the word.
template <typename Names>
auto read_word(const JsonReader& json, const Names& names) {
    const std::string word = json.string();
    std::string allowed;
    for (const auto& [name, value] : names) {
        if (name == word) return value;
        allowed += (allowed.empty() ? "one of " : ", ") + std::string(name);
    }
    json.refuse(allowed);
}

double read_mass(const JsonReader& json, const BodyDescription& body) {
    if (!json.has("density_kg_per_m3")) return json.at("mass_kg").number(engine::least_mass, engine::greatest_mass);
    const JsonReader density = json.at("density_kg_per_m3");
    const double volume = std::visit(
        engine::Overloaded{
            [](const BoxShape& box) { return box.size.prod(); },
            [](const SphereShape& sphere) { return 4.0 / 3.0 * std::numbers::pi * std::pow(sphere.radius, 3); },
            [](const PlaneShape&) { return 0.0; },
            [](const PolyhedronShape& polyhedron) { return polyhedron.volume; }},
        body.shape);
    const double mass = density.positive() * volume;
    if (!(mass >= engine::least_mass && mass <= engine::greatest_mass)) {
        density.refuse(
            fmt::format("such that the mass is from {:g} to {:g} kg", engine::least_mass, engine::greatest_mass));
    }
    return mass;
}

BodyDescription read_body(const JsonReader& json, Polyhedra& polyhedra) {
    json.require_object(body_keys);
    BodyDescription body{.name = json.at("name").string(), .shape = read_shape(json)};
    const bool fixed = json.has("static") && json.at("static").boolean();
    refuse_foreign_keys(json, body, fixed);
    const bool is_polyhedron = std::holds_alternative<PolyhedronShape>(body.shape);
    FramedPolyhedron polyhedron;
    if (is_polyhedron) {
        polyhedron = read_polyhedron(json, polyhedra);
        body.shape = polyhedron.shape;
    }
    if (!fixed && !std::holds_alternative<PlaneShape>(body.shape)) body.mass = read_mass(json, body);

    if (json.has("motion")) {
        if (body.mass)
            json.at("motion").refuse("left out of a body with a mass; \"static\": true makes it one without");
        body.motion = read_motion(json.at("motion"));
    }

    const auto vector = [&json](const char* key, Vector3& into) {
        if (json.has(key)) into = json.at(key).vector();
    };
    vector("position_m", body.position);
    if (json.has("orientation_wxyz")) body.orientation = json.at("orientation_wxyz").rotation();
    vector("velocity_m_per_s", body.velocity);
    vector("angular_velocity_rad_per_s", body.angular_velocity);
    vector("surface_velocity_m_per_s", body.surface_velocity);
    if (json.has("surface_from_s")) body.surface_from = json.at("surface_from_s").number(0.0, 1e9);
    if (json.has("linear_momentum_kg_m_per_s"))
        body.linear_momentum = json.at("linear_momentum_kg_m_per_s").vector();
    if (json.has("angular_momentum_kg_m2_per_s"))
        body.angular_momentum = json.at("angular_momentum_kg_m2_per_s").vector();
    if (json.has("friction")) body.friction = json.at("friction").number(0.0, 100.0);
    if (json.has("restitution")) body.restitution = json.at("restitution").number(0.0, 1.0);
    if (json.has("material")) body.material = read_name(json.at("material"));
    if (json.has("group")) body.group = read_name(json.at("group"));
    if (is_polyhedron) {
        give_polyhedron(body, polyhedron);
        polyhedra.by_body[body.name] = polyhedron;
    }
    return body;
}

// All bodies so far by name, and whether they are static; constraints and forces look theirs up.
using Names = std::map<std::string, bool, std::less<>>;

std::string read_body_name(const JsonReader& json, const Names& names, bool or_world) {
    std::string name = json.string();
    if (!names.contains(name) && !(or_world && name == "world")) {
        json.refuse(or_world ? "the name of a body, or world" : "the name of a body");
    }
    return name;
}

DistanceDescription::End read_end(const JsonReader& json, const Names& names) {
    json.require_object(end_keys);
    DistanceDescription::End end{.body = read_body_name(json.at("body"), names, true)};
    if (json.has("point_m")) end.point = json.at("point_m").vector();
    return end;
}

// Two ends of something, at least one of them on a movable body.
template <typename Described>
Described read_ends(const JsonReader& json, const Names& names) {
    Described described{.a = read_end(json.at("a"), names), .b = read_end(json.at("b"), names)};
    if (described.a.body == described.b.body) json.at("b").at("body").refuse("another body than a");
    const auto is_static = [&](const std::string& name) { return name == "world" || names.at(name); };
    if (is_static(described.a.body) && is_static(described.b.body)) {
        json.at("b").at("body").refuse("a movable body, as a is static");
    }
    return described;
}

engine::Motor read_motor(const JsonReader& json) {
    json.require_object(motor_keys);
    engine::Motor motor{.speed = json.at("speed_rad_per_s").number(-1e9, 1e9)};
    if (json.has("max_torque_n_m")) motor.max_torque = json.at("max_torque_n_m").positive();
    return motor;
}

engine::AngleLimits read_limits(const JsonReader& json) {
    const std::string allowed = "two angles from -6.2832 to 6.2832, the second from the first to a turn above it";
    const std::vector<double> limits = json.numbers(2, allowed);
    constexpr double turn = 2.0 * std::numbers::pi;
    const bool in_range = std::abs(limits[0]) <= turn && std::abs(limits[1]) <= turn;
    if (!in_range || limits[1] < limits[0] || limits[1] > limits[0] + turn) json.refuse(allowed);
    return {limits[0], limits[1]};
}

JointDescription read_joint(const JsonReader& json, const Names& names) {
    json.require_object(joint_keys);
    auto joint = read_ends<JointDescription>(json, names);
    const std::string type = json.at("type").string();
    if (json.has("collide")) joint.collide = json.at("collide").boolean();
    if (type == "ball") {
        refuse_if_given(json, {"axis", "zero_wxyz", "motor", "limits_rad"}, "left out: a ball joint has no axis");
        return joint;
    }
    if (type != "hinge") json.at("type").refuse("one of hinge, ball");
    HingeDescription& hinge = joint.hinge.emplace();
    hinge.axis = json.at("axis").vector();
    if (const double length = hinge.axis.norm(); !(length >= 1e-100 && length <= 1e100)) {
        json.at("axis").refuse("a vector from 1e-100 to 1e+100 long");
    }
    if (json.has("zero_wxyz")) hinge.zero = json.at("zero_wxyz").rotation();
    if (json.has("motor")) hinge.motor = read_motor(json.at("motor"));
    if (json.has("limits_rad")) hinge.limits = read_limits(json.at("limits_rad"));
    return joint;
}

engine::Spring read_spring(const JsonReader& json) {
    json.require_object(spring_keys);
    const auto number = [&](const char* key) { return json.has(key) ? json.at(key).number(0.0, 1e100) : 0.0; };
    const engine::Spring spring{number("stiffness_n_per_m"), number("damping_n_s_per_m")};
    if (std::max(spring.stiffness, spring.damping) < 1e-100) {
        json.refuse("given a stiffness or a damping from 1e-100 to 1e+100");
    }
    return spring;
}

DistanceDescription read_distance(const JsonReader& json, const Names& names) {
    json.require_object(distance_keys);
    auto distance = read_ends<DistanceDescription>(json, names);
    if (json.has("length_m")) distance.length = json.at("length_m").not_negative();
    if (json.has("max_force_n")) distance.max_force = json.at("max_force_n").positive();
    if (json.has("acts")) distance.acts = read_word(json.at("acts"), act_names);
    if (json.has("spring")) {
        refuse_if_given(json, {"acts", "max_force_n"}, "left out of a spring");
        distance.spring = read_spring(json.at("spring"));
        if (distance.length == 0.0)
            json.at("length_m").refuse("above 0, as a spring of no length has no direction");
    }
    if (distance.length == 0.0 && (distance.acts != engine::Distance::Acts::both || distance.max_force)) {
        json.at("length_m").refuse("above 0, or it is a ball joint, which acts both ways and without max_force_n");
    }
    return distance;
}

ForceDescription read_force(const JsonReader& json, const Names& names) {
    json.require_object(force_keys);
    ForceDescription force{.body = read_body_name(json.at("body"), names, false)};
    if (json.has("torque_n_m")) force.torque = json.at("torque_n_m").vector();
    if (json.has("force_n") || !json.has("torque_n_m")) force.force = json.at("force_n").vector();
    if (json.has("point_m")) {
        if (!json.has("force_n")) json.at("point_m").refuse("left out without force_n: a torque acts at no point");
        force.point = json.at("point_m").vector();
    }
    if (json.has("frame")) force.frame = read_word(json.at("frame"), frame_names);
    if (json.has("from_s")) force.from = json.at("from_s").number(0.0, 1e9);
    if (json.has("until_s")) force.until = json.at("until_s").number(force.from, 1e9);
    return force;
}

std::pair<std::string, std::string> read_no_contact(const JsonReader& json, const Names& names) {
    const std::vector<JsonReader> ends = json.elements();
    if (ends.size() != 2) json.refuse("two names of bodies");
    std::pair<std::string, std::string> pair{read_body_name(ends[0], names, false),
                                             read_body_name(ends[1], names, false)};
    if (pair.first == pair.second) ends[1].refuse("another body than the first");
    return pair;
}

void read_material_pairs(const JsonReader& json, SceneDescription& scene) {
    std::set<std::string> known;
    for (const BodyDescription& body : scene.bodies) known.insert(body.material);
    const auto material = [&](const JsonReader& name) {
        if (!known.contains(read_name(name))) name.refuse("the material of a body");
        return name.string();
    };
    std::set<std::pair<std::string, std::string>> pairs;
    for (const JsonReader& entry : json.elements()) {
        entry.require_object(material_pair_keys);
        MaterialPairDescription pair{.a = material(entry.at("a")), .b = material(entry.at("b"))};
        if (!pairs.insert(std::minmax(pair.a, pair.b)).second) entry.refuse("a pair that is listed once");
        if (entry.has("friction")) pair.friction = entry.at("friction").number(0.0, 100.0);
        if (entry.has("restitution")) pair.restitution = entry.at("restitution").number(0.0, 1.0);
        if (!pair.friction && !pair.restitution) entry.refuse("given friction or restitution, or both");
        scene.materials.push_back(pair);
    }
}

void read_bodies(const JsonReader& json, SceneDescription& scene, Names& names, Polyhedra& polyhedra) {
    const std::vector<JsonReader> bodies = json.elements();
    if (bodies.size() > most_bodies) json.refuse(fmt::format("at most {} bodies", most_bodies));
    for (const JsonReader& body : bodies) {
        scene.bodies.push_back(read_body(body, polyhedra));
        const std::string& name = scene.bodies.back().name;
        if (name.empty() || name == "world") body.at("name").refuse("a name other than world");
        if (!names.emplace(name, !scene.bodies.back().mass).second)
            body.at("name").refuse("a name that no other body has");
    }
}

void read_options(const JsonReader& json, SceneDescription& scene) {
    json.require_object();
    for (const auto& [name, value] : json.json().items()) {
        if (!value.is_string() && !value.is_number()) json.at(name).refuse("a string or a number");
        scene.options[name] = value.is_string() ? value.get<std::string>() : value.dump();
    }
}

void read_colours(const JsonReader& json, SceneDescription& scene) {
    std::map<std::string, BodyDescription*> bodies;
    for (BodyDescription& body : scene.bodies) bodies[body.name] = &body;
    json.require_object();
    for (const auto& [name, value] : json.json().items()) {
        const JsonReader colour = json.at(name);
        if (!bodies.contains(name)) colour.refuse("given to a body of the scene");
        if (!find_colour(colour.string())) colour.refuse("one of " + colour_names());
        bodies[name]->colour = colour.string();
    }
}

SceneDescription read_scene(const JsonReader& json, const std::filesystem::path& file) {
    json.require_object(scene_keys);
    SceneDescription scene;
    scene.name = json.has("name") ? json.at("name").string() : file.stem().string();
    // It becomes the name of a folder of frames, so it must not lead elsewhere.
    const bool plain =
        !scene.name.empty() && scene.name.front() != '.' && scene.name.find('/') == std::string::npos;
    if (json.has("name") && !plain) json.at("name").refuse("a name without slashes that does not begin with a dot");
    if (json.at("version").number(0, 1e9) != scene_file_version)
        json.at("version").refuse(std::to_string(scene_file_version));
    scene.gravity = json.has("gravity_m_per_s2") ? json.at("gravity_m_per_s2").vector() : Vector3::Zero();

    Names names;
    Polyhedra polyhedra{.folder = file.parent_path()};
    read_bodies(json.at("bodies"), scene, names, polyhedra);
    if (json.has("distance_constraints")) {
        for (const JsonReader& entry : json.at("distance_constraints").elements()) {
            scene.distances.push_back(to_body_frames(read_distance(entry, names), polyhedra));
        }
    }
    if (json.has("joints")) {
        for (const JsonReader& entry : json.at("joints").elements())
            scene.joints.push_back(to_body_frames(read_joint(entry, names), polyhedra));
    }
    if (json.has("forces")) {
        for (const JsonReader& entry : json.at("forces").elements())
            scene.forces.push_back(to_body_frame(read_force(entry, names), entry.has("point_m"), polyhedra));
    }
    scene.contacts = json.has("contacts") && json.at("contacts").boolean();
    if (json.has("no_contacts")) {
        for (const JsonReader& entry : json.at("no_contacts").elements())
            scene.no_contacts.push_back(read_no_contact(entry, names));
    }
    if (json.has("material_pairs")) read_material_pairs(json.at("material_pairs"), scene);
    if (json.has("state")) scene.state = std::make_shared<RunState>(read_state(json.at("state"), scene));
    if (json.has("options")) read_options(json.at("options"), scene);
    scene.has_camera = json.has("camera");
    if (scene.has_camera) scene.view = read_camera(json.at("camera"));
    if (json.has("colours")) read_colours(json.at("colours"), scene);
    return scene;
}

}  // namespace

const std::map<std::string, std::vector<std::string>>& scene_file_keys() {
    static const std::map<std::string, std::vector<std::string>> keys = [] {
        std::map<std::string, std::vector<std::string>> all = state_file_keys();
        all.insert(motion_file_keys().begin(), motion_file_keys().end());
        all.insert({
            {"scene", scene_keys},
            {"body", body_keys},
            {"distance_constraint", distance_keys},
            {"spring", spring_keys},
            {"joint", joint_keys},
            {"motor", motor_keys},
            {"end", end_keys},
            {"force", force_keys},
            {"material_pair", material_pair_keys},
            {"camera", {camera_keys().begin(), camera_keys().end()}},
        });
        return all;
    }();
    return keys;
}

SceneDescription read_scene_file(const std::filesystem::path& file) {
    const Json json = read_json_file(file, file.string());
    return read_scene(JsonReader(json, file.string()), file);
}

}  // namespace pushfactor::demos
