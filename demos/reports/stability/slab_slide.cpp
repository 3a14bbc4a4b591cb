#include "demos/reports/stability/slab_slide.h"

#include "engine/base/math.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::demos::reports::stability {

namespace {

using Plane = Eigen::Vector2d;            // x and z
using Moving = Eigen::Vector<double, 6>;  // x, z, angle; their rates

// Of a slab of 1 kg.
double inertia_of(const Slab& slab) {
    return slab.side * slab.side / 6.0;
}

double energy_of(const Slab& slab, const Moving& now) {
    return 0.5 * (now.segment<2>(3).squaredNorm() + inertia_of(slab) * now[5] * now[5]);
}

Moving rate_of(const Slab& slab, const Moving& now) {
    const double below = 0.5 * slab.height;
    Eigen::Matrix<double, 2, 4> places, directions;
    Eigen::Matrix<double, 3, 4> balance;  // weight, moments about z and x, of loads 1
    for (int i = 0; i < 4; ++i) {
        const Plane corner = 0.5 * slab.side * Plane(i < 2 ? 1 : -1, i % 2 == 0 ? 1 : -1);
        const Plane place = Eigen::Rotation2Dd(-now[2]) * corner;
        const Plane sliding = now.segment<2>(3) + now[5] * Plane(place.y(), -place.x());
        places.col(i) = place;
        directions.col(i) = sliding.stableNormalized();
        balance.col(i) << 1.0, place - slab.friction * below * directions.col(i);
    }
    Eigen::Matrix<double, 4, 3> linear;
    linear << Eigen::Vector4d::Ones(), places.transpose();
    const Eigen::Matrix3d system = balance * linear;
    const Eigen::Vector4d loads = linear * system.partialPivLu().solve(Eigen::Vector3d(slab.gravity, 0, 0));
    Moving rate;
    rate << now.tail<3>(), 0, 0, 0;
    for (int i = 0; i < 4; ++i) {
        const Plane force = -slab.friction * loads[i] * directions.col(i);
        rate.segment<2>(3) += force;
        rate[5] += (places(1, i) * force.x() - places(0, i) * force.y()) / inertia_of(slab);
    }
    return rate;
}

}  // namespace

double slide_of(const Slab& slab, double speed, double spin) {
    Moving now;
    now << 0, 0, 0, speed, 0, spin;
    const double start = energy_of(slab, now);
    // RK4. Both speeds vanish at the same time, and steps shrink with them.
    for (double left = 1.0; left > 1e-5; left = std::sqrt(energy_of(slab, now) / start)) {
        const double h = 1e-3 * std::max(left, 1e-3);  // s
        const Moving k1 = rate_of(slab, now);
        const Moving k2 = rate_of(slab, now + 0.5 * h * k1);
        const Moving k3 = rate_of(slab, now + 0.5 * h * k2);
        const Moving k4 = rate_of(slab, now + h * k3);
        now += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    return now.head<2>().norm();
}

}  // namespace pushfactor::demos::reports::stability
