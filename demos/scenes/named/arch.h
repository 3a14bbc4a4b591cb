// What limit analysis says of semicircular arches.
#pragma once

namespace pushfactor::demos::scenes {

constexpr double arch_friction = 0.7;  // between its stones

// An arch whose mean radius is 1.
struct ArchShape {
    int voussoirs = 15;
    double thickness = 0.12;
    double half_angle = 1.5707963267948966;  // rad, from the crown to a springing
};

// Whether forces exist that carry the arch's weight within its joints: compression alone, inside the joint, and no
// steeper to its normal than friction allows (Heyman, The stone skeleton, 1966). Symmetric forces are enough.
bool can_stand(const ArchShape& shape, double friction);

// The least thickness, between 0.01 and 1, and the least friction, between 0 and 2, of an arch that can stand; to
// 1e-9.
double least_thickness(ArchShape shape, double friction);
double least_friction(const ArchShape& shape);

// Of a semicircle of very many voussoirs that do not slip (Milankovitch 1907).
inline constexpr double milankovitch = 0.1075;

}  // namespace pushfactor::demos::scenes
