#include "demos/reports/stability/measures/tracks.h"

namespace pushfactor::demos::reports::stability {

std::vector<Track> tracks(const Evidence& evidence) {
    std::vector<Track> found;
    for (const BodyDescription& body : evidence.scene->bodies) {
        if (body.mass) found.push_back({.body = &body});
    }
    const Columns& all = evidence.outputs.at("trajectory");
    for (std::size_t i = 0; i < all.at("time_s").size(); ++i) {
        const auto at = [&](const char* column) { return all.at(column)[i]; };
        found[i % found.size()].states.push_back(
            {.time = at("time_s"),
             .x = {at("x_m"), at("y_m"), at("z_m")},
             .v = {at("vx_m_per_s"), at("vy_m_per_s"), at("vz_m_per_s")},
             .w = {at("wx_rad_per_s"), at("wy_rad_per_s"), at("wz_rad_per_s")},
             .orientation = engine::Quaternion(at("qw"), at("qx"), at("qy"), at("qz"))});
    }
    return found;
}

}  // namespace pushfactor::demos::reports::stability
