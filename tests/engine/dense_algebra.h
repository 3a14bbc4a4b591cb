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

// The shortest rotation of `from` to the direction of `to`; neither is zero.
engine::Quaternion rotation_between(const engine::Vector3& from, const engine::Vector3& to);

}  // namespace pushfactor::tests
