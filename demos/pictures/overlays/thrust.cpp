#include "demos/pictures/overlays/thrust.h"

#include <map>

namespace pushfactor::demos::pictures {

using engine::Vector3;

std::vector<PressureCentre> pressure_centres(const BuiltScene& scene) {
    struct Pressure {
        Vector3 moment = Vector3::Zero();  // N m, sum of force times place
        double force = 0.0;                // N
    };
    std::map<std::pair<int, int>, Pressure> pairs;
    const auto add = [&](const engine::ContactSite& site, double force) {
        Pressure& pressure = pairs[{site.body_a, site.body_b}];
        pressure.moment += force * site.position;
        pressure.force += force;
    };
    const engine::Columns& lambda = scene.world.lambda();
    for (const engine::ContactSite& site : scene.contacts->sites())
        add(site, lambda(static_cast<Eigen::Index>(site.normal_row), lambda.cols() - 1));
    for (const engine::RestingContact& contact : scene.contacts->sites_at_rest(scene.world.bodies))
        add(contact.site, contact.normal);
    std::vector<PressureCentre> centres;
    for (const auto& [bodies, pressure] : pairs) {
        if (!(pressure.force > 0.0)) continue;
        centres.push_back({bodies.first, bodies.second, pressure.moment / pressure.force});
    }
    return centres;
}

std::vector<std::pair<Vector3, Vector3>> line_of_thrust(const std::vector<PressureCentre>& centres,
                                                        const BuiltScene& scene) {
    std::map<int, std::vector<Vector3>> of_body;
    for (const PressureCentre& centre : centres) {
        for (const int body : {centre.body_a, centre.body_b}) {
            if (!scene.world.bodies[static_cast<std::size_t>(body)].is_static())
                of_body[body].push_back(centre.place);
        }
    }
    std::vector<std::pair<Vector3, Vector3>> line;
    for (const auto& [body, places] : of_body) {
        if (places.size() == 2) line.emplace_back(places.front(), places.back());
    }
    return line;
}

}  // namespace pushfactor::demos::pictures
