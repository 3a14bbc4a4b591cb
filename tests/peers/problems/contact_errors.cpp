#include "tests/peers/problems/contact_errors.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pushfactor::tests::problems {

namespace {

using engine::Matrix3;
using engine::Vector3;
using engine::VectorX;

// The closest point of the cone |x_T| <= mu x_n.
Vector3 into_cone(const Vector3& x, double mu) {
    const double tangential = x.tail<2>().norm();
    if (tangential <= mu * x[0]) return x;
    if (mu * tangential <= -x[0]) return Vector3::Zero();
    const double normal = (x[0] + mu * tangential) / (1.0 + mu * mu);
    Vector3 result(normal, 0.0, 0.0);
    if (tangential > 0.0) result.tail<2>() = (mu * normal / tangential) * x.tail<2>();
    return result;
}

// r - P_K(r - step (u + mu |u_T| n)).
Vector3 miss(const Vector3& r, const Vector3& u, double mu, double step) {
    Vector3 shifted = u;
    shifted[0] += mu * u.tail<2>().norm();
    return r - into_cone(r - step * shifted, mu);
}

// The largest eigenvalue of the symmetric part of W's block of a contact.
double stiffness(const SparseMatrix& matrix, Eigen::Index contact) {
    const Matrix3 block = SparseMatrix(matrix.middleCols(3 * contact, 3)).toDense().middleRows<3>(3 * contact);
    const Eigen::SelfAdjointEigenSolver<Matrix3> solver(0.5 * (block + block.transpose()), Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[2];
}

// Relative to the radius of the disc, so that rounding does not count as inside.
constexpr double edge = 1e-6;

double wrong_friction_of(const Vector3& r, const Vector3& u, double mu) {
    const double tangential = r.tail<2>().norm(), radius = mu * r[0], sliding = u.tail<2>().norm();
    if (radius <= 0.0) return 0.0;
    if (tangential < (1.0 - edge) * radius) return sliding;
    const Eigen::Vector2d direction = r.tail<2>() / tangential;
    const double along = u.tail<2>().dot(direction);
    return along > 0.0 ? sliding : (u.tail<2>() - along * direction).norm();
}

}  // namespace

ContactErrors contact_errors(const LocalProblem& problem, const VectorX& impulses) {
    const VectorX velocities = problem.matrix * impulses + problem.free;
    ContactErrors errors;
    double squares = 0.0;
    for (Eigen::Index contact = 0; contact < problem.contacts(); ++contact) {
        const Vector3 r = impulses.segment<3>(3 * contact), u = velocities.segment<3>(3 * contact);
        const double mu = problem.mu[contact];
        squares += miss(r, u, mu, 1.0).squaredNorm();
        const double largest = stiffness(problem.matrix, contact);
        if (largest > 0.0) {
            errors.natural_map = std::max(errors.natural_map, largest * miss(r, u, mu, 1.0 / largest).norm());
        }
        errors.penetration_rate = std::max(errors.penetration_rate, -u[0]);
        errors.cone_violation = std::max({errors.cone_violation, r.tail<2>().norm() - mu * r[0], -r[0]});
        errors.wrong_friction = std::max(errors.wrong_friction, wrong_friction_of(r, u, mu));
    }
    const double scale = std::max({problem.free.norm(), impulses.norm(), velocities.norm()});
    errors.siconos = scale > 0.0 ? std::sqrt(squares) / scale : std::sqrt(squares);
    errors.dissipation = -impulses.dot(velocities);
    return errors;
}

}  // namespace pushfactor::tests::problems
