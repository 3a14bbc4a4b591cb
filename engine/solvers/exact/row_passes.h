// Passes over all rows of a problem: from forces to velocities, and back. The same bits for each instruction set
// (instruction_sets.h).
#pragma once

namespace pushfactor::engine::solvers {

// Consecutive rows `begin` .. `end` - 1 between the same two bodies.
struct RowSpan {
    int begin = 0, end = 0;
    int a = 0, b = 0;
};

// v += U^T y. Of each row `units` has six numbers for body a and six for body b, and `v` six of each body.
void push_rows(const RowSpan* spans, int count, const double* units, const double* y, double* v);

// speeds = U v
void find_speeds(const RowSpan* spans, int count, const double* units, const double* v, double* speeds);

}  // namespace pushfactor::engine::solvers
