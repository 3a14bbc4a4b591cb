#include "tests/fuzz/shrink.h"

#include <cstdio>
#include <cstdlib>
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

// Every scene that is one step simpler than `scene_`, the greatest steps first.
class Simplifications {
  public:
    explicit Simplifications(const SceneDescription& scene) : scene_(scene) {
        drop_bodies();
        drop_each(&SceneDescription::distances);
        drop_each(&SceneDescription::forces);
        drop_options();
        calm();
        for (const int digits : {1, 2, 3}) round(digits);
    }

    std::vector<SceneDescription> take() { return std::move(found_); }

  private:
    // With what hangs on it.
    void drop_bodies() {
        for (const BodyDescription& body : scene_.bodies) {
            SceneDescription simpler = scene_;
            std::erase_if(simpler.bodies, [&](const auto& other) { return other.name == body.name; });
            std::erase_if(simpler.distances,
                          [&](const auto& d) { return d.a.body == body.name || d.b.body == body.name; });
            std::erase_if(simpler.forces, [&](const auto& force) { return force.body == body.name; });
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

    // How long it runs stays, and what the other options change.
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
            set(body.orientation, Quaternion(Quaternion::Identity()));
            set(body.restitution, 0.0);
            set(body.friction, 0.0);
            become_box(body);
        }
        for (auto& distance : edited_.distances) {
            set(distance.acts, engine::Distance::Acts::both);
            set(distance.max_force, std::optional<double>());
        }
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
