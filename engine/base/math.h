// Vector types of the engine.
#pragma once

#include "engine/base/elementary.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <limits>

namespace pushfactor::engine {

using Vector3 = Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;  // linear part, then angular part (paper 6.1.1)
using Matrix3 = Eigen::Matrix3d;
using VectorX = Eigen::VectorXd;
using MatrixX = Eigen::MatrixXd;
using Quaternion = Eigen::Quaterniond;

// One line per constraint row, one or two columns. The first column moves positions, the last one sets momenta;
// with one column both are the same.
using Columns = Eigen::MatrixXd;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// By an angle [rad] about a unit vector. Eigen's AngleAxis takes sin and cos of the C library.
inline Quaternion turn_about(const Vector3& axis, double angle) {
    const auto [sine, cosine] = elementary::sine_cosine(0.5 * angle);
    Quaternion turn;
    turn.w() = cosine;
    turn.vec() = sine * axis;
    return turn;
}

inline Vector6 stacked(const Vector3& linear, const Vector3& angular) {
    Vector6 both;
    both.head<3>() = linear;
    both.tail<3>() = angular;
    return both;
}

}  // namespace pushfactor::engine
