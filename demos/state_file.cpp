#include "demos/state_file.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace pushfactor::demos {

namespace {

using engine::ContactCache;
using engine::Lambda;
using engine::Vector3;
using engine::collision::Pair;

using Keys = std::vector<std::string>;
const Keys state_keys{"time_s", "solved_exactly", "kept_steps", "substeps", "distance_forces_n", "contact_forces"};
const Keys contact_keys{"a", "b", "points"};
const Keys point_keys{"feature", "position_m", "normal_n", "friction_first_n", "friction_last_n"};

double whole_number(const JsonReader& json, double low, double high) {
    const double number = json.number(low, high);
    if (number != std::floor(number)) json.refuse("a whole number");
    return number;
}

Lambda read_lambda(const JsonReader& json) {
    const std::vector<double> columns = json.numbers(2, "two numbers [first column, last column]");
    return {columns[0], columns[1]};
}

std::vector<Lambda> read_distance_forces(const JsonReader& json, const SceneDescription& scene) {
    std::vector<Lambda> forces;
    for (const JsonReader& entry : json.elements()) forces.push_back(read_lambda(entry));
    if (forces.size() != scene.distances.size()) {
        json.refuse(fmt::format("an array of {} forces, one a distance constraint", scene.distances.size()));
    }
    return forces;
}

ContactCache::Point read_point(const JsonReader& json) {
    json.require_object(point_keys);
    ContactCache::Point point;
    point.feature = static_cast<std::uint32_t>(
        whole_number(json.at("feature"), 0.0, std::numeric_limits<std::uint32_t>::max()));
    point.position = json.at("position_m").vector();
    point.force.normal = read_lambda(json.at("normal_n"));
    point.force.friction_first = json.at("friction_first_n").vector();
    point.force.friction_last = json.at("friction_last_n").vector();
    return point;
}

ContactCache read_contact_forces(const JsonReader& json, const SceneDescription& scene) {
    std::map<std::string, int, std::less<>> indices;
    for (const BodyDescription& body : scene.bodies) indices.emplace(body.name, static_cast<int>(indices.size()));
    const auto index_of = [&](const JsonReader& name) {
        const auto found = indices.find(name.string());
        if (found == indices.end()) name.refuse("the name of a body");
        return found->second;
    };
    ContactCache cache;
    for (const JsonReader& entry : json.elements()) {
        entry.require_object(contact_keys);
        const Pair pair{index_of(entry.at("a")), index_of(entry.at("b"))};
        if (pair.a >= pair.b) entry.at("b").refuse("a body that is listed after a");
        if (!cache.entries().empty() && !(cache.entries().back().pair < pair)) {
            entry.refuse("a pair that comes after the one before, in the order of the bodies");
        }
        std::vector<ContactCache::Point> points;
        for (const JsonReader& point : entry.at("points").elements()) points.push_back(read_point(point));
        cache.add(pair, points);
    }
    return cache;
}

Json to_json(const Vector3& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Json to_json(const Lambda& lambda) {
    return Json::array({lambda.first, lambda.last});
}

Json to_json(const ContactCache::Point& point) {
    return {{"feature", point.feature},
            {"position_m", to_json(point.position)},
            {"normal_n", to_json(point.force.normal)},
            {"friction_first_n", to_json(point.force.friction_first)},
            {"friction_last_n", to_json(point.force.friction_last)}};
}

Json to_json(const ContactCache::Entry& entry, const ContactCache& cache, const SceneDescription& scene) {
    const auto name = [&](int index) { return scene.bodies[static_cast<std::size_t>(index)].name; };
    Json json{{"a", name(entry.pair.a)}, {"b", name(entry.pair.b)}, {"points", Json::array()}};
    for (const auto& point : cache.points().subspan(entry.first, static_cast<std::size_t>(entry.count))) {
        json["points"].push_back(to_json(point));
    }
    return json;
}

}  // namespace

const std::map<std::string, std::vector<std::string>>& state_file_keys() {
    static const std::map<std::string, std::vector<std::string>> keys{
        {"state", state_keys}, {"contact_force", contact_keys}, {"contact_force_point", point_keys}};
    return keys;
}

RunState read_state(const JsonReader& json, const SceneDescription& scene) {
    json.require_object(state_keys);
    RunState state;
    if (json.has("time_s")) state.time = json.at("time_s").number(0.0, 1e9);
    if (json.has("solved_exactly")) state.solved_exactly = json.at("solved_exactly").boolean();
    if (json.has("kept_steps")) state.kept_steps = static_cast<int>(whole_number(json.at("kept_steps"), 0.0, 1e9));
    if (json.has("substeps")) state.substeps = json.at("substeps").number(0.0, 10000.0);
    state.distance_forces.resize(scene.distances.size());
    if (json.has("distance_forces_n")) {
        state.distance_forces = read_distance_forces(json.at("distance_forces_n"), scene);
    }
    if (json.has("contact_forces")) state.contact_forces = read_contact_forces(json.at("contact_forces"), scene);
    return state;
}

Json state_json(const RunState& state, const SceneDescription& scene) {
    Json json{{"time_s", state.time},
              {"solved_exactly", state.solved_exactly},
              {"kept_steps", state.kept_steps},
              {"substeps", state.substeps}};
    for (const Lambda& force : state.distance_forces) json["distance_forces_n"].push_back(to_json(force));
    for (const ContactCache::Entry& entry : state.contact_forces.entries()) {
        json["contact_forces"].push_back(to_json(entry, state.contact_forces, scene));
    }
    return json;
}

}  // namespace pushfactor::demos
