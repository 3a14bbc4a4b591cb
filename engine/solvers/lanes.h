// Two doubles worked on at once, in the vector extension that g++ and clang++ share: every lane has the bits that a
// double would have. An inner matter of the solvers.
#pragma once

#include "engine/constraints/constraint_row.h"

#include <array>
#include <cmath>
#include <utility>

namespace pushfactor::engine::solvers {

using Two [[gnu::vector_size(16), gnu::may_alias]] = double;

// One value for each column of the system: a double for one, both lanes for two.
template <int columns>
struct Lanes;

template <>
struct Lanes<1> {
    using Value = double;

    static Value of(const std::array<double, 1>& values) { return values[0]; }
    static void write(Value value, std::array<double, 1>& to) { to[0] = value; }
    static Value all(double value) { return value; }
    static double in(Value value, int) { return value; }
    static double largest(Value value) { return value; }

    // The sums of both lanes of each column's sum.
    static Value sum(const Two (&sums)[1]) { return sums[0][0] + sums[0][1]; }
};

template <>
struct Lanes<2> {
    using Value = Two;

    static Value of(const std::array<double, 2>& values) { return Two{values[0], values[1]}; }
    static void write(Value value, std::array<double, 2>& to) { to = {value[0], value[1]}; }
    static Value all(double value) { return Two{value, value}; }
    static double in(Value value, int column) { return value[column]; }
    static double largest(Value value) { return value[0] < value[1] ? value[1] : value[0]; }

    static Value sum(const Two (&sums)[2]) {
        return __builtin_shufflevector(sums[0], sums[1], 0, 2) + __builtin_shufflevector(sums[0], sums[1], 1, 3);
    }
};

// Calls `body` with 0, 1, .. count - 1 as constants: a loop that short costs more than what it repeats.
template <int count, typename Body>
void unrolled(const Body& body) {
    [&]<int... i>(std::integer_sequence<int, i...>) {
        (body(std::integral_constant<int, i>()), ...);
    }
    (std::make_integer_sequence<int, count>());
}

// As std::min, std::max and std::abs, in each lane.
template <typename Value>
Value smaller(Value a, Value b) {
    return b < a ? b : a;
}
template <typename Value>
Value larger(Value a, Value b) {
    return a < b ? b : a;
}
template <typename Value>
Value magnitude(Value a) {
    return larger(a, -a);
}

inline double root(double a) {
    return std::sqrt(a);
}
inline Two root(Two a) {
    return Two{std::sqrt(a[0]), std::sqrt(a[1])};
}

// The numbers of the two bodies of a row, three pairs each, where they are in memory.
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

// The scalar product is the sum of both lanes. In three pairs, so that they do not all wait for each other.
inline Two products(const Axis& u, const Axis& v) {
    return (u.a[0] * v.a[0] + u.b[0] * v.b[0]) + (u.a[1] * v.a[1] + u.b[1] * v.b[1]) +
           (u.a[2] * v.a[2] + u.b[2] * v.b[2]);
}

// v += sum of u_i y_i, each number of v taken from memory once.
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
