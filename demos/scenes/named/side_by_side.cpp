#include "demos/scenes/named/side_by_side.h"

#include <algorithm>

namespace pushfactor::demos::scenes {

namespace {

bool same_static_body(const BodyDescription& a, const BodyDescription& b) {
    return !a.mass && !b.mass && a.shape == b.shape && a.position == b.position &&
           a.orientation.coeffs() == b.orientation.coeffs() && a.friction == b.friction &&
           a.restitution == b.restitution && a.surface_velocity == b.surface_velocity &&
           a.surface_from == b.surface_from && a.material == b.material && a.group.empty() && b.group.empty();
}

class Together {
  public:
    void add(const SceneDescription& scene) {
        ++number_;
        names_.clear();
        const auto before = static_cast<std::ptrdiff_t>(all.bodies.size());
        for (const BodyDescription& body : scene.bodies) {
            const auto end = all.bodies.begin() + before;
            const auto known = std::find_if(all.bodies.begin(), end,
                                            [&](const auto& other) { return same_static_body(body, other); });
            if (known != end) {
                names_[body.name] = known->name;
                continue;
            }
            names_[body.name] = std::to_string(number_) + " " + body.name;
            all.bodies.push_back(body);
            all.bodies.back().name = names_[body.name];
            std::string& group = all.bodies.back().group;
            if (!group.empty()) group = std::to_string(number_) + " " + group;
        }
        for (const DistanceDescription& distance : scene.distances) all.distances.push_back(renamed(distance));
        for (const JointDescription& joint : scene.joints) all.joints.push_back(renamed(joint));
        for (ForceDescription force : scene.forces) {
            force.body = names_.at(force.body);
            all.forces.push_back(force);
        }
        for (const auto& [a, b] : scene.no_contacts) all.no_contacts.emplace_back(names_.at(a), names_.at(b));
        for (const MaterialPairDescription& pair : scene.materials) add(pair);
        all.contacts = all.contacts || scene.contacts;
    }

    SceneDescription all;

  private:
    template <typename Described>
    Described renamed(Described described) const {
        for (DistanceDescription::End* end : {&described.a, &described.b}) {
            if (end->body != "world") end->body = names_.at(end->body);
        }
        return described;
    }

    // A material is the same in all scenes; the first one to speak of a pair is heard.
    void add(const MaterialPairDescription& pair) {
        const bool known = std::any_of(all.materials.begin(), all.materials.end(), [&](const auto& other) {
            return std::minmax(other.a, other.b) == std::minmax(pair.a, pair.b);
        });
        if (!known) all.materials.push_back(pair);
    }

    int number_ = 0;
    std::map<std::string, std::string> names_;  // in the scene at hand, and in all
};

}  // namespace

SceneDescription side_by_side(const std::string& name, std::span<const SceneDescription> scenes) {
    Together together;
    together.all.name = name;
    if (!scenes.empty()) {
        together.all.gravity = scenes.front().gravity;
        together.all.view = scenes.front().view;
        together.all.has_camera = scenes.front().has_camera;
    }
    for (const SceneDescription& scene : scenes) together.add(scene);
    return together.all;
}

}  // namespace pushfactor::demos::scenes
