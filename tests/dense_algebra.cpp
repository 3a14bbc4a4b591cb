#include "tests/dense_algebra.h"

#include <Eigen/Dense>

namespace pushfactor::tests {

using engine::MatrixX;
using engine::VectorX;

MatrixX product(const MatrixX& a, const MatrixX& b) {
    return a * b;
}

MatrixX inverse(const MatrixX& matrix) {
    return matrix.fullPivLu().inverse();
}

MatrixX pseudo_inverse(const MatrixX& matrix) {
    return matrix.completeOrthogonalDecomposition().pseudoInverse();
}

Eigen::Index rank(const MatrixX& matrix) {
    return matrix.fullPivLu().rank();
}

VectorX solution(const MatrixX& A, const VectorX& b) {
    return A.fullPivLu().solve(b);
}

VectorX least_solution(const MatrixX& A, const VectorX& b, double threshold) {
    Eigen::CompleteOrthogonalDecomposition<MatrixX> inverse;
    inverse.setThreshold(threshold);
    inverse.compute(A);
    return inverse.solve(b);
}

engine::Quaternion rotation_between(const engine::Vector3& from, const engine::Vector3& to) {
    return engine::Quaternion::FromTwoVectors(from, to);
}

}  // namespace pushfactor::tests
