// Dense linear algebra of any size for tests. Not templates: Eigen's factorisations take seconds to compile.
#pragma once

#include "engine/base/math.h"

namespace pushfactor::tests {

engine::MatrixX product(const engine::MatrixX& a, const engine::MatrixX& b);
engine::MatrixX inverse(const engine::MatrixX& matrix);
engine::MatrixX pseudo_inverse(const engine::MatrixX& matrix);
Eigen::Index rank(const engine::MatrixX& matrix);

// x with A x = b for an invertible A, by elimination with full pivoting.
engine::VectorX solution(const engine::MatrixX& A, const engine::VectorX& b);

// Of least norm among the best solutions of A x = b, for a symmetric A whose pivots below `threshold` times the
// largest count as zero.
engine::VectorX least_solution(const engine::MatrixX& A, const engine::VectorX& b, double threshold);

// The shortest rotation of `from` to the direction of `to`; neither is zero.
engine::Quaternion rotation_between(const engine::Vector3& from, const engine::Vector3& to);

}  // namespace pushfactor::tests
