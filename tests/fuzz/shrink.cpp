#include "tests/fuzz/shrink.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

namespace pushfactor::tests {

namespace {

using demos::BodyDescription;
using demos::SceneDescription;
using engine::Quaternion;
using engine::Vector3;

double rounded(double value, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return std::strtod(text, nullptr);
}

// Every scene that is one simplification away from `scene_`, the greatest first.
class Simplifications {
  public:
    explicit Simplifications(const SceneDescription& scene) : scene_(scene) {
        drop_bodies();
        drop_each(&SceneDescription::distances);
        drop_each(&SceneDescription::joints);
        drop_each(&SceneDescription::forces);
        drop_each(&SceneDescription::no_contacts);
        drop_each(&SceneDescription::materials);
        drop_options();
        calm();
        for (const int digits : {1, 2, 3}) round(digits);
    }

    std::vector<SceneDescription> take() { return std::move(found_); }

  private:
    static bool has_material(const SceneDescription& scene, const std::string& name) {
        return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                           [&](const BodyDescription& body) { return body.material == name; });
    }

    // With everything that refers to it.
    void drop_bodies() {
        for (const BodyDescription& body : scene_.bodies) {
            SceneDescription simpler = scene_;
            std::erase_if(simpler.bodies, [&](const auto& other) { return other.name == body.name; });
            std::erase_if(simpler.distances,
                          [&](const auto& d) { return d.a.body == body.name || d.b.body == body.name; });
            std::erase_if(simpler.joints, [&](const auto& joint) {
                return joint.a.body == body.name || joint.b.body == body.name;
            });
            std::erase_if(simpler.forces, [&](const auto& force) { return force.body == body.name; });
            std::erase_if(simpler.no_contacts,
                          [&](const auto& pair) { return pair.first == body.name || pair.second == body.name; });
            std::erase_if(simpler.materials, [&](const auto& pair) {
                return !has_material(simpler, pair.a) || !has_material(simpler, pair.b);
            });
            found_.push_back(std::move(simpler));
        }
    }

    template <typename Described>
    void drop_each(std::vector<Described> SceneDescription::*list) {
        for (std::size_t i = 0; i < (scene_.*list).size(); ++i) {
            SceneDescription simpler = scene_;
            (simpler.*list).erase((simpler.*list).begin() + static_cast<std::ptrdiff_t>(i));
            found_.push_back(std::move(simpler));
        }
    }

    // Keeps the duration and the effects of the other options.
    void drop_options() {
        for (const auto& [name, text] : scene_.options) {
            if (name == "preset" || name == "seconds" || name == "dt") continue;
            SceneDescription simpler = scene_;
            simpler.options.erase(name);
            found_.push_back(std::move(simpler));
        }
    }

    // Adds the scene with `field` of something in it as `value`, unless it is that already.
    template <typename Value>
    void set(Value& field, const Value& value) {
        if (field == value) return;
        Value before = value;
        std::swap(before, field);
        found_.push_back(edited_);
        std::swap(before, field);
    }
    void set(Quaternion& field, const Quaternion& value) { set(field.coeffs(), value.coeffs()); }

    void calm() {
        edited_ = scene_;
        set(edited_.gravity, Vector3(Vector3::Zero()));
        set(edited_.contacts, false);
        for (BodyDescription& body : edited_.bodies) {
            set(body.velocity, Vector3(Vector3::Zero()));
            set(body.angular_velocity, Vector3(Vector3::Zero()));
            set(body.surface_velocity, Vector3(Vector3::Zero()));
            set(body.surface_from, 0.0);
            if (body.motion) drop_motion(body);
            set(body.orientation, Quaternion(Quaternion::Identity()));
            set(body.restitution, 0.0);
            set(body.friction, 0.0);
            become_box(body);
            set(body.group, std::string());
        }
        for (auto& force : edited_.forces) {
            set(force.torque, Vector3(Vector3::Zero()));
            set(force.point, Vector3(Vector3::Zero()));
            set(force.frame, engine::Poke::Frame::world);
        }
        for (auto& distance : edited_.distances) {
            set(distance.acts, engine::Distance::Acts::both);
            set(distance.max_force, std::optional<double>());
            if (!distance.spring) continue;
            const auto spring = std::exchange(distance.spring, std::nullopt);
            found_.push_back(edited_);
            distance.spring = spring;
        }
        for (auto& joint : edited_.joints) {
            set(joint.collide, false);
            if (!joint.hinge) continue;
            SceneDescription simpler = edited_;
            auto& hinge = simpler.joints[static_cast<std::size_t>(&joint - edited_.joints.data())].hinge;
            const auto add_without = [&](auto part) {
                if (!((*hinge).*part)) return;
                const auto before = std::exchange((*hinge).*part, std::nullopt);
                found_.push_back(simpler);
                (*hinge).*part = before;
            };
            add_without(&demos::HingeDescription::motor);
            add_without(&demos::HingeDescription::limits);
            hinge.reset();
            found_.push_back(std::move(simpler));
        }
    }

    // All of it, or its limits.
    void drop_motion(BodyDescription& body) {
        const auto before = body.motion;
        body.motion.reset();
        found_.push_back(edited_);
        body.motion = before;
        set(body.motion->from, 0.0);
        set(body.motion->until, std::optional<double>());
    }

    // A polyhedron as the box that holds it.
    void become_box(BodyDescription& body) {
        const auto* polyhedron = std::get_if<demos::PolyhedronShape>(&body.shape);
        if (!polyhedron) return;
        Vector3 size = Vector3::Zero();
        for (const Vector3& point : polyhedron->points()) size = size.cwiseMax(2.0 * point.cwiseAbs());
        const auto before = body.shape;
        body.shape = demos::BoxShape{size};
        found_.push_back(edited_);
        body.shape = before;
    }

    void round_number(double& number, int digits) { set(number, rounded(number, digits)); }
    void round_vector(Vector3& vector, int digits) {
        for (double& component : vector) round_number(component, digits);
    }

    void round(int digits) {
        edited_ = scene_;
        for (BodyDescription& body : edited_.bodies) {
            if (body.mass) round_number(*body.mass, digits);
            if (auto* box = std::get_if<demos::BoxShape>(&body.shape)) round_vector(box->size, digits);
            if (auto* sphere = std::get_if<demos::SphereShape>(&body.shape)) round_number(sphere->radius, digits);
            for (Vector3* v : {&body.position, &body.velocity, &body.angular_velocity}) round_vector(*v, digits);
            round_number(body.friction, digits);
            round_number(body.restitution, digits);
        }
        for (auto& distance : edited_.distances) {
            round_vector(distance.a.point, digits);
            round_vector(distance.b.point, digits);
            if (distance.length) round_number(*distance.length, digits);
        }
    }

    const SceneDescription& scene_;
    SceneDescription edited_;  // a copy whose fields are changed one at a time
    std::vector<SceneDescription> found_;
};

}  // namespace

SceneDescription shrink(SceneDescription scene, const Fails& fails, int most_tries) {
    for (int tries = 0; tries < most_tries;) {
        bool simpler = false;
        for (SceneDescription& candidate : Simplifications(scene).take()) {
            if (++tries > most_tries) break;
            if (!fails(candidate)) continue;
            scene = std::move(candidate);
            simpler = true;
            break;
        }
        if (!simpler) break;
    }
    return scene;
}

}  // namespace pushfactor::tests
