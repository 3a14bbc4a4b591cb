// Jolt, single precision.
#include "tests/peers/engine.h"
#include "tests/peers/jolt_world.h"

#include <limits>

namespace pushfactor::tests::peers {

namespace {

std::array<float, 3> to_jolt(const Vector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

Vector3 from_jolt(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

JoltShape shape_of(const Body& body) {
    return body.shape == Shape::plane ? JoltShape::plane
           : body.shape == Shape::box ? JoltShape::box
                                      : JoltShape::sphere;
}

JoltBody to_jolt(const Body& body, bool moves) {
    const State& s = body.start;
    const Quaternion& q = s.orientation;
    JoltBody result;
    result.shape = shape_of(body);
    result.half_edges = to_jolt(0.5 * body.size);
    result.radius = static_cast<float>(body.radius);
    result.friction = static_cast<float>(body.friction);
    result.restitution = static_cast<float>(body.restitution);
    result.start = {to_jolt(s.position),
                    {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z()),
                     static_cast<float>(q.w())},
                    to_jolt(s.velocity),
                    to_jolt(s.angular_velocity)};
    if (!moves) return result;
    result.mass = static_cast<float>(body.mass);
    result.moments = to_jolt(inertia(body));
    return result;
}

JoltScene to_jolt(const Scene& scene) {
    const int first = static_cast<int>(scene.fixed.size());  // movable body in the list of all
    JoltScene result;
    result.gravity = to_jolt(scene.gravity);
    result.contacts = scene.contacts;
    result.step = static_cast<float>(scene.step);
    for (const Body& body : scene.fixed) result.bodies.push_back(to_jolt(body, false));
    for (const Body& body : scene.movable) result.bodies.push_back(to_jolt(body, true));
    for (const Link& link : scene.links)
        result.links.push_back({link.a < 0 ? -1 : first + link.a, first + link.b, to_jolt(link.point_a),
                                to_jolt(link.point_b), static_cast<float>(link.length)});
    return result;
}

class JoltEngine : public World {
  public:
    explicit JoltEngine(const Scene& scene)
        : first_(scene.fixed.size()), count_(scene.movable.size()), world_(to_jolt(scene)) {}

    void step() override { complete_ = world_.step() && complete_; }

    std::vector<State> states() const override {
        std::vector<State> result;
        for (std::size_t i = first_; i < first_ + count_; ++i) {
            const JoltState s = world_.state(i);
            const auto& q = s.orientation;
            result.push_back({from_jolt(s.position), Quaternion(q[3], q[0], q[1], q[2]), from_jolt(s.velocity),
                              from_jolt(s.angular_velocity)});
            // Contacts left out for lack of room: no result of Jolt's solver.
            if (!complete_) result.back().position.setConstant(std::numeric_limits<double>::quiet_NaN());
        }
        return result;
    }

  private:
    std::size_t first_, count_;  // movable bodies in the list of all
    JoltWorld world_;
    bool complete_ = true;
};

Setting setting(const std::vector<std::string>& cases) {
    Setting result;
    result.engine = "Jolt " + jolt_version();
    result.name = "as shipped with 10 and 2 iterations, never sleeps, no damping";
    result.cases = cases;
    result.build = [](const Scene& scene) { return std::make_unique<JoltEngine>(scene); };
    return result;
}

}  // namespace

std::vector<Setting> jolt_settings() {
    return {setting({}), setting({"piles", "tosses"})};
}

std::vector<Series> jolt_series() {
    return {};
}

}  // namespace pushfactor::tests::peers
