// Pairs of doubles, with the vector extension shared by g++ and clang++: each lane gives the same bits as a scalar
// double. Internal to the solvers.
#pragma once

#include "engine/base/instruction_sets.h"
#include "engine/constraints/constraint_row.h"

#include <utility>

namespace pushfactor::engine::solvers {

inline double sum_of(Two pair) {
    return pair[0] + pair[1];
}

// Calls `body` with 0, 1, .. count - 1 as compile-time constants: the overhead of such short loops exceeds their
// body.
template <int count, typename Body>
[[gnu::always_inline]] inline void unrolled(const Body& body) {
    [&]<int... i>(std::integer_sequence<int, i...>) __attribute__((always_inline)) {
        (body(std::integral_constant<int, i>()), ...);
    }
    (std::make_integer_sequence<int, count>());
}

// Pointers to the numbers of a row's two bodies, three pairs each.
struct Axis {
    const Two* a;
    const Two* b;
};
struct Velocity {
    Two* a;
    Two* b;
    operator Axis() const { return {a, b}; }
};

inline Axis axis_of(const Jacobian& unit) {
    return {reinterpret_cast<const Two*>(unit.a.data()), reinterpret_cast<const Two*>(unit.b.data())};
}

// Dot product, to be summed over both lanes. Three independent partial sums shorten the dependency chain.
inline Two products(const Axis& u, const Axis& v) {
    return (u.a[0] * v.a[0] + u.b[0] * v.b[0]) + (u.a[1] * v.a[1] + u.b[1] * v.b[1]) +
           (u.a[2] * v.a[2] + u.b[2] * v.b[2]);
}

inline double product(const Jacobian& u, const Jacobian& v) {
    return sum_of(products(axis_of(u), axis_of(v)));
}

// v += sum of u_i y_i, with one load and store per number of v.
template <std::size_t count>
void add(const Velocity& v, const Axis (&u)[count], const double (&y)[count]) {
    unrolled<3>([&](auto k) {
        Two a = v.a[k], b = v.b[k];
        unrolled<count>([&](auto i) { a += u[i].a[k] * y[i], b += u[i].b[k] * y[i]; });
        v.a[k] = a;
        v.b[k] = b;
    });
}

}  // namespace pushfactor::engine::solvers
