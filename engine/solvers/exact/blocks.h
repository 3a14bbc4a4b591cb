// Arithmetic of 6 x 6 blocks and of 6 numbers per body, for BodyMatrix. Blocks are arrays of 36 doubles, column by
// column. No two arguments overlap. The same bits for each instruction set (instruction_sets.h).
#pragma once

namespace pushfactor::engine::solvers::blocks {

// a += w v u^T, a += w (v u^T - v_2 u_2^T)
void add_outer(double* a, double w, const double* v, const double* u);
void add_difference(double* a, double w, const double* v, const double* u, const double* v_2, const double* u_2);
// a += b^T
void add_transposed(double* a, const double* b);

// c -= a b, c -= a b^T
void subtract_product(double* c, const double* a, const double* b);
void subtract_product_with_transposed(double* c, const double* a, const double* b);

// c = a c, c = c a^T
void multiply(double* c, const double* a);
void multiply_with_transposed(double* c, const double* a);

// y -= a x, y -= a^T x
void subtract_times(double* y, const double* a, const double* x);
void subtract_transposed_times(double* y, const double* a, const double* x);

// Inverts a general matrix in place: Gauss-Jordan with column pivoting. Non-finite if singular.
void invert(double* a);
// Replaces the lower triangle of a symmetric positive definite matrix by the inverse of its Cholesky factor, and
// the rest by zeros. With the inverse all further steps are products, without dependent divisions.
void invert_factor(double* a);

}  // namespace pushfactor::engine::solvers::blocks
