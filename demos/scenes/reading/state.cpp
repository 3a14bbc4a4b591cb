// The part of a scene file from which a saved run is resumed.
#include "demos/scenes/reading/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pushfactor::demos {

namespace {

using engine::ContactCache;
using engine::DistanceForce;
using engine::JointForce;
using engine::Lambda;
using engine::Rest;
using engine::Vector3;
using engine::collision::Pair;

// Of earlier versions, which mean nothing any more.
const Keys warm_start_keys{"bodies", "solved_exactly", "kept_steps", "exact_debt_multiply_adds", "exact_failures"};

// A body that is still, or was. Without position and orientation it is where it was then.
struct Place {
    std::string body{};
    bool wide = false;  // of earlier versions, not used
    double still = 0.0;
    std::optional<double> here{};
    std::optional<Vector3> position{};
    std::optional<engine::Quaternion> orientation{};
    Vector3 spin = Vector3::Zero();
};

struct Contact {
    std::string a{}, b{};
    std::vector<ContactCache::Point> points{};
};

double whole_number(const JsonReader& json, double low, double high) {
    const double number = json.number(low, high);
    if (number != std::floor(number)) json.refuse("a whole number");
    return number;
}

Lambda read_lambda(const JsonReader& json) {
    const std::vector<double> columns = json.numbers(2, "two numbers [first column, last column]");
    return {columns[0], columns[1]};
}

// Two numbers for a bar, three times two for a ball joint. Older files have two for a ball joint, which are
// ignored.
DistanceForce read_distance_force(const JsonReader& json, const DistanceDescription& distance) {
    const bool joint = distance.length == 0.0;
    if (!json.json().is_array() || json.json().empty() || !json.json().front().is_array()) {
        const Lambda along_bar = read_lambda(json);
        return joint ? DistanceForce{} : DistanceForce{along_bar};
    }
    const std::vector<JsonReader> axes = json.elements();
    if (axes.size() != 3) json.refuse("two numbers, or three times two of a ball joint");
    return {read_lambda(axes[0]), read_lambda(axes[1]), read_lambda(axes[2])};
}

std::vector<DistanceForce> read_distance_forces(const JsonReader& json, const SceneDescription& scene) {
    const std::vector<JsonReader> entries = json.elements();
    std::vector<DistanceForce> forces;
    for (std::size_t i = 0; i < entries.size() && i < scene.distances.size(); ++i) {
        forces.push_back(read_distance_force(entries[i], scene.distances[i]));
    }
    if (entries.size() != scene.distances.size()) {
        json.refuse(fmt::format("an array of {} forces, one per distance constraint", scene.distances.size()));
    }
    return forces;
}

std::size_t rows_of(const JointDescription& joint) {
    engine::Joint rows;
    if (joint.hinge) rows.hinge = {.motor = joint.hinge->motor, .limits = joint.hinge->limits};
    return row_count(rows);
}

std::vector<JointForce> read_joint_forces(const JsonReader& json, const SceneDescription& scene) {
    const std::vector<JsonReader> entries = json.elements();
    if (entries.size() != scene.joints.size()) {
        json.refuse(fmt::format("an array of {} lists of forces, one a joint", scene.joints.size()));
    }
    std::vector<JointForce> forces(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::vector<JsonReader> rows = entries[i].elements();
        const std::size_t count = rows_of(scene.joints[i]);
        // Older files have rows of limits beside a motor without a largest torque, too: the last ones, without use.
        JointDescription older = scene.joints[i];
        if (older.hinge && older.hinge->motor) older.hinge->motor->max_torque = 1.0;
        if (rows.size() != count && rows.size() != rows_of(older))
            entries[i].refuse(fmt::format("{} times two numbers, one per row", count));
        std::transform(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count), forces[i].begin(),
                       read_lambda);
    }
    return forces;
}

// Unused angles are written as 0.
Json angles_json(const std::vector<double>& angles) {
    Json json = Json::array();
    for (const double angle : angles) json.push_back(std::isnan(angle) ? 0.0 : angle);
    return json;
}

std::uint32_t read_feature(const JsonReader& json) {
    return static_cast<std::uint32_t>(whole_number(json, 0.0, std::numeric_limits<std::uint32_t>::max()));
}

using BodyIndices = std::map<std::string, int>;  // by name

int index_of(const JsonReader& name, const BodyIndices& indices) {
    const auto found = indices.find(name.string());
    if (found == indices.end()) name.refuse("the name of a body");
    return found->second;
}

// What earlier versions remembered of their solver, which changes nothing now: still has to be what they wrote.
void check_memory(const JsonReader& json) {
    if (json.has("solved_exactly")) json.at("solved_exactly").boolean();
    if (json.has("kept_steps")) whole_number(json.at("kept_steps"), 0.0, 1e9);
    if (json.has("exact_debt_multiply_adds")) json.at("exact_debt_multiply_adds").number(0.0, 1e15);
    if (json.has("exact_failures")) json.at("exact_failures").number(0.0, 1e3);
    if (json.has("force_rate_per_s")) json.at("force_rate_per_s").number(0.0, 1e300);
}

void check_warm_start(const JsonReader& json, const BodyIndices& indices) {
    for (const JsonReader& entry : json.elements()) {
        entry.require_object(warm_start_keys);
        check_memory(entry);
        for (const JsonReader& name : entry.at("bodies").elements()) index_of(name, indices);
    }
}

}  // namespace

void describe(Fields& fields, RunState& state) {
    fields.may("time_s", state.time, between(0.0, 1e9));
    fields.may("substeps", state.parts, between(0.0, 10000.0));
}

void describe(Fields& fields, Place& place) {
    fields.must("body", place.body, &JsonReader::string);
    fields.if_any("wide", place.wide, &JsonReader::boolean);
    fields.may("still_s", place.still, between(0.0, 1e9));
    fields.if_any("here_s", place.here, between(0.0, 1e9));
    fields.if_any("position_m", place.position, &JsonReader::vector);
    fields.if_any("orientation_wxyz", place.orientation, &JsonReader::rotation);
    fields.if_any("angular_momentum_kg_m2_per_s", place.spin, &JsonReader::vector);
}

void describe(Fields& fields, ContactCache::Point& point) {
    fields.must("feature", point.feature, read_feature);
    fields.must("position_m", point.position, &JsonReader::vector);
    fields.must("normal_n", point.force.normal, read_lambda);
    fields.must("friction_first_n", point.force.friction_first, &JsonReader::vector);
    fields.must("friction_last_n", point.force.friction_last, &JsonReader::vector);
}

void describe(Fields& fields, Contact& contact) {
    fields.must("a", contact.a, &JsonReader::string);
    fields.must("b", contact.b, &JsonReader::string);
    fields.must("points", contact.points,
                [](const JsonReader& json) { return read_each(json, read_object<ContactCache::Point>); });
}

namespace {

const Keys& all_state_keys() {
    static const Keys keys =
        joined({keys_of<RunState>(),
                {"warm_start", "distance_forces_n", "joint_forces_n", "joint_angles_rad", "contact_forces",
                 "places", "at_rest", "solved_exactly", "kept_steps", "force_rate_per_s"}});
    return keys;
}

std::vector<Rest::Memory> read_places(const JsonReader& json, const SceneDescription& scene,
                                      const BodyIndices& indices) {
    std::vector<Rest::Memory> memory(scene.bodies.size());
    for (const JsonReader& entry : json.elements()) {
        const auto place = read_object<Place>(entry);
        const auto index = static_cast<std::size_t>(index_of(entry.at("body"), indices));
        if (place.wide) continue;
        Rest::Memory& stay = memory[index];
        stay.position = place.position.value_or(scene.bodies[index].position);
        stay.orientation = place.orientation.value_or(scene.bodies[index].orientation);
        stay.still = place.still;
        stay.here = place.here.value_or(place.still);
        stay.spin = place.spin;
    }
    return memory;
}

// A ball at rest may go on turning in place (rest.h).
bool moves(const BodyDescription& body) {
    const bool turns = !body.angular_momentum.value_or(body.angular_velocity).isZero(0.0);
    return !body.linear_momentum.value_or(body.velocity).isZero(0.0) ||
           (turns && !std::holds_alternative<SphereShape>(body.shape));
}

// Groups of bodies that came to rest together.
void read_at_rest(const JsonReader& json, const SceneDescription& scene, const BodyIndices& indices,
                  std::vector<Rest::Memory>& memory) {
    memory.resize(scene.bodies.size());
    for (const JsonReader& group : json.elements()) {
        int first = -1;
        for (const JsonReader& name : group.elements()) {
            const int body = index_of(name, indices);
            const BodyDescription& described = scene.bodies[static_cast<std::size_t>(body)];
            if (!described.mass) name.refuse("the name of a movable body");
            if (moves(described)) name.refuse("a body without velocity and momentum");
            if (first < 0) first = body;
            memory[static_cast<std::size_t>(body)].group = first;
        }
    }
}

ContactCache read_contact_forces(const JsonReader& json, const BodyIndices& indices) {
    ContactCache cache;
    for (const JsonReader& entry : json.elements()) {
        const auto contact = read_object<Contact>(entry);
        const Pair pair{index_of(entry.at("a"), indices), index_of(entry.at("b"), indices)};
        if (pair.a >= pair.b) entry.at("b").refuse("a body that is listed after a");
        if (!cache.entries().empty() && !(cache.entries().back().pair < pair)) {
            entry.refuse("a pair that comes after the one before, in the order of the bodies");
        }
        cache.add(pair, contact.points);
    }
    return cache;
}

Json force_json(const DistanceForce& force, bool joint) {
    if (!joint) return to_json(force[0]);
    return Json::array({to_json(force[0]), to_json(force[1]), to_json(force[2])});
}

Json contact_json(const ContactCache::Entry& entry, const ContactCache& cache, const SceneDescription& scene) {
    const auto name = [&](int index) { return scene.bodies[static_cast<std::size_t>(index)].name; };
    const auto points = cache.points().subspan(entry.first, static_cast<std::size_t>(entry.count));
    return to_json(Contact{name(entry.pair.a), name(entry.pair.b), {points.begin(), points.end()}});
}

Json places_json(const RunState& state, const SceneDescription& scene) {
    Json json = Json::array();
    for (std::size_t i = 0; i < scene.bodies.size() && i < state.rest.size(); ++i) {
        const BodyDescription& body = scene.bodies[i];
        if (!body.mass) continue;
        const Rest::Memory& stay = state.rest[i];
        const auto differs = [](const engine::Quaternion& a, const engine::Quaternion& b) {
            return a.coeffs() != b.coeffs();
        };
        const bool is_noted = stay.still > 0.0 || !stay.position.isZero(0.0) || !stay.spin.isZero(0.0) ||
                              differs(stay.orientation, engine::Quaternion::Identity());
        if (!is_noted) continue;  // not yet
        Place place{.body = body.name, .still = stay.still, .spin = stay.spin};
        if (stay.here != stay.still) place.here = stay.here;
        if (stay.position != body.position) place.position = stay.position;
        if (differs(stay.orientation, body.orientation)) place.orientation = stay.orientation;
        json.push_back(to_json(place));
    }
    return json;
}

Json at_rest_json(const RunState& state, const SceneDescription& scene) {
    std::map<int, Json> groups;
    for (std::size_t i = 0; i < scene.bodies.size() && i < state.rest.size(); ++i) {
        if (state.rest[i].group >= 0) groups[state.rest[i].group].push_back(scene.bodies[i].name);
    }
    Json json = Json::array();
    for (const auto& [number, names] : groups) json.push_back(names);
    return json;
}

}  // namespace

KeysByObject state_keys() {
    return {{"state", all_state_keys()},
            {"warm_start", warm_start_keys},
            {"place", keys_of<Place>()},
            {"contact_force", keys_of<Contact>()},
            {"contact_force_point", keys_of<ContactCache::Point>()}};
}

RunState read_state(const JsonReader& json, const SceneDescription& scene) {
    json.require_object(all_state_keys());
    RunState state;
    Fields fields(json);
    describe(fields, state);
    BodyIndices indices;
    for (const BodyDescription& body : scene.bodies) indices.emplace(body.name, static_cast<int>(indices.size()));
    check_memory(json);
    if (json.has("warm_start")) check_warm_start(json.at("warm_start"), indices);
    state.distance_forces.resize(scene.distances.size());
    if (json.has("distance_forces_n")) {
        state.distance_forces = read_distance_forces(json.at("distance_forces_n"), scene);
    }
    state.joint_forces.resize(scene.joints.size());
    if (json.has("joint_forces_n")) state.joint_forces = read_joint_forces(json.at("joint_forces_n"), scene);
    if (json.has("joint_angles_rad")) {
        const std::size_t count = scene.joints.size();
        state.joint_angles =
            json.at("joint_angles_rad").numbers(count, fmt::format("an array of {} angles, one a joint", count));
    }
    if (json.has("contact_forces")) state.contact_forces = read_contact_forces(json.at("contact_forces"), indices);
    if (json.has("places")) state.rest = read_places(json.at("places"), scene, indices);
    if (json.has("at_rest")) read_at_rest(json.at("at_rest"), scene, indices, state.rest);
    return state;
}

Json state_json(const RunState& state, const SceneDescription& scene) {
    Json json = to_json(state);
    for (std::size_t i = 0; i < state.distance_forces.size(); ++i) {
        const bool joint = scene.distances[i].length == 0.0;
        json["distance_forces_n"].push_back(force_json(state.distance_forces[i], joint));
    }
    for (std::size_t i = 0; i < state.joint_forces.size(); ++i) {
        Json& rows = json["joint_forces_n"].emplace_back(Json::array());
        for (std::size_t j = 0; j < rows_of(scene.joints[i]); ++j)
            rows.push_back(to_json(state.joint_forces[i][j]));
    }
    const bool knows_angles = std::ranges::any_of(state.joint_angles, [](double a) { return !std::isnan(a); });
    if (knows_angles) json["joint_angles_rad"] = angles_json(state.joint_angles);
    for (const ContactCache::Entry& entry : state.contact_forces.entries()) {
        json["contact_forces"].push_back(contact_json(entry, state.contact_forces, scene));
    }
    if (Json places = places_json(state, scene); !places.empty()) json["places"] = places;
    if (Json at_rest = at_rest_json(state, scene); !at_rest.empty()) json["at_rest"] = at_rest;
    return json;
}

}  // namespace pushfactor::demos
