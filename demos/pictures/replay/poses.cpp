#include "demos/pictures/replay/poses.h"

#include "demos/pictures/replay/integers.h"

namespace pushfactor::demos::pictures::replay {

std::array<std::int64_t, 3> vector_in_units(const engine::Vector3& vector, double unit) {
    return {in_units(vector.x(), unit), in_units(vector.y(), unit), in_units(vector.z(), unit)};
}

std::array<std::int64_t, 4> orientation_in_units(const engine::Quaternion& orientation,
                                                 const std::array<std::int64_t, 4>& last) {
    const std::array parts{orientation.w(), orientation.x(), orientation.y(), orientation.z()};
    double along = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) along += parts[i] * static_cast<double>(last[i]);
    std::array<std::int64_t, 4> units{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        units[i] = in_units(along < 0.0 ? -parts[i] : parts[i], orientation_unit);
    }
    return units;
}

}  // namespace pushfactor::demos::pictures::replay
