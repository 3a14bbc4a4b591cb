#include "tests/peers/scene.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <map>
#include <stdexcept>

namespace pushfactor::tests::peers {

namespace {

using Json = nlohmann::json;

Vector3 vector(const Json& numbers) {
    return Vector3(numbers.at(0).get<double>(), numbers.at(1).get<double>(), numbers.at(2).get<double>());
}

Vector3 vector_or_zero(const Json& object, const char* key) {
    return object.contains(key) ? vector(object.at(key)) : Vector3(Vector3::Zero());
}

Body read_body(const Json& json) {
    Body body;
    const std::string shape = json.at("shape");
    body.shape = shape == "plane" ? Shape::plane : shape == "box" ? Shape::box : Shape::sphere;
    if (body.shape == Shape::box) body.size = vector(json.at("size_m"));
    if (body.shape == Shape::sphere) body.radius = json.at("radius_m");
    body.mass = json.value("mass_kg", 0.0);
    body.friction = json.value("friction", 0.5);
    body.start.position = vector_or_zero(json, "position_m");
    body.start.velocity = vector_or_zero(json, "velocity_m_per_s");
    body.start.angular_velocity = vector_or_zero(json, "angular_velocity_rad_per_s");
    if (json.contains("orientation_wxyz")) {
        const Json& q = json.at("orientation_wxyz");
        body.start.orientation =
            Quaternion(q.at(0).get<double>(), q.at(1).get<double>(), q.at(2).get<double>(), q.at(3).get<double>());
    }
    return body;
}

Link read_link(const Json& json, const std::map<std::string, int>& places) {
    Link link;
    link.a = places.at(json.at("a").at("body"));
    link.b = places.at(json.at("b").at("body"));
    link.point_a = vector_or_zero(json.at("a"), "point_m");
    link.point_b = vector_or_zero(json.at("b"), "point_m");
    link.length = json.at("length_m");
    return link;
}

Vector3 end(int body, const Vector3& point, const std::vector<State>& states) {
    if (body < 0) return point;
    const State& state = states[static_cast<std::size_t>(body)];
    return state.position + state.orientation * point;
}

}  // namespace

Scene read_scene(const std::string& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file + ": cannot be read");
    const Json json = Json::parse(in);

    Scene scene;
    scene.name = json.at("name");
    scene.gravity = vector_or_zero(json, "gravity_m_per_s2");
    scene.contacts = json.contains("contacts") && json.at("contacts") != false;
    std::map<std::string, int> places{{"world", -1}};
    for (const Json& body : json.at("bodies")) {
        if (body.value("static", false) || !body.contains("mass_kg")) {
            scene.fixed.push_back(read_body(body));
        } else {
            places[body.at("name")] = static_cast<int>(scene.movable.size());
            scene.movable.push_back(read_body(body));
        }
    }
    // An option of the file that comes before the bodies' own friction.
    const Json options = json.value("options", Json::object());
    if (options.contains("friction")) {
        for (std::vector<Body>* bodies : {&scene.fixed, &scene.movable}) {
            for (Body& body : *bodies) body.friction = options.at("friction");
        }
    }
    for (const Json& link : json.value("distance_constraints", Json::array()))
        scene.links.push_back(read_link(link, places));
    return scene;
}

Vector3 inertia(const Body& body) {
    if (!body.moments.isZero()) return body.moments;
    if (body.shape == Shape::sphere) return Vector3::Constant(0.4 * body.mass * body.radius * body.radius);
    const Vector3 squares = body.size.cwiseAbs2();
    return body.mass / 12.0 * (Vector3::Constant(squares.sum()) - squares);
}

Vector3 end_a(const Link& link, const std::vector<State>& states) {
    return end(link.a, link.point_a, states);
}

Vector3 end_b(const Link& link, const std::vector<State>& states) {
    return end(link.b, link.point_b, states);
}

std::vector<State> starts(const Scene& scene) {
    std::vector<State> states;
    for (const Body& body : scene.movable) states.push_back(body.start);
    return states;
}

}  // namespace pushfactor::tests::peers
