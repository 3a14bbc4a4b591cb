// The exact torque-free rotation of a body with three different moments of inertia: Euler's equations, solved by
// Jacobi elliptic functions (Landau & Lifshitz, Mechanics, section 37), and a precession about the angular
// momentum. The reference for tumbling bodies.
//
//   l_z = l_z(0) dn(w t, m),  l_a = l_a(0) cn(w t, m),  l_b = C sn(w t, m)
//   phi' = L (l_a^2 / I_a + l_b^2 / I_b) / (l_a^2 + l_b^2)
//
// Symbols: l angular momentum in the body frame [kg m^2/s], L its length; b the axis of the middle moment, z the
// one of the others whose part of l never vanishes, a the third; I principal moments [kg m^2]; w rate [rad/s]; m
// parameter of the elliptic functions, in [0, 1); phi angle [rad] by which the line where the planes across l and
// across z meet has turned about l.
#pragma once

#include "engine/base/math.h"

namespace pushfactor::demos::scenes {

struct FreeBody {
    engine::Vector3 inertia;       // I: principal moments along the axes of the body frame, three different ones
    engine::Quaternion start;      // orientation at t = 0, body to world
    engine::Vector3 angular_rate;  // at t = 0, body frame, rad/s: none about b, some about the others
};

class FreeRotation {
  public:
    // Throws engine::InvalidInput for motions that the formulas do not cover: a start outside the plane of a and z,
    // rotation about one axis alone, and the separatrix.
    explicit FreeRotation(const FreeBody& body);

    // The orientation at `time` [s], not earlier than in the last call. Exact to about 1e-13.
    engine::Quaternion at(double time);

  private:
    engine::Vector3 momentum(double time) const;  // l
    double precession_rate(double time) const;    // phi'
    engine::Matrix3 frame(const engine::Vector3& l) const;

    engine::Vector3 inertia_;
    Eigen::Index a_, b_, z_;
    double l_a_, l_b_, l_z_;  // l_a(0), C, l_z(0)
    double rate_;             // w
    double parameter_;        // m
    engine::Matrix3 to_world_;
    double time_ = 0.0, phi_ = 0.0;
};

struct Elliptic {
    double sn = 0.0, cn = 1.0, dn = 1.0;
};

// Jacobi's functions of argument u and parameter m in [0, 1), by the arithmetic-geometric mean (Abramowitz & Stegun
// 16.4).
Elliptic jacobi_elliptic(double u, double m);

}  // namespace pushfactor::demos::scenes
