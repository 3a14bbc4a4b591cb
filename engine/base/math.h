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

inline Vector6 stacked(const Vector3& linear, const Vector3& angular) {
    Vector6 both;
    both.head<3>() = linear;
    both.tail<3>() = angular;
    return both;
}

}  // namespace pushfactor::engine
