// Units in the type system: a sum of different units does not compile. For checking the paper's section 9 alone;
// the engine computes with plain numbers.
#pragma once

#include <concepts>

namespace pushfactor::tests::units {

// A number in kg^kg m^m s^s. Angles have no unit (9.1: rad = m/m).
template <int kg, int m, int s>
struct Quantity {
    double value = 1.0;
};

template <int kg, int m, int s>
constexpr Quantity<kg, m, s> operator+(Quantity<kg, m, s> a, Quantity<kg, m, s> b) {
    return {a.value + b.value};
}

template <int kg, int m, int s>
constexpr Quantity<kg, m, s> operator-(Quantity<kg, m, s> a, Quantity<kg, m, s> b) {
    return {a.value - b.value};
}

template <int kg_a, int m_a, int s_a, int kg_b, int m_b, int s_b>
constexpr Quantity<kg_a + kg_b, m_a + m_b, s_a + s_b> operator*(Quantity<kg_a, m_a, s_a> a,
                                                                Quantity<kg_b, m_b, s_b> b) {
    return {a.value * b.value};
}

template <int kg_a, int m_a, int s_a, int kg_b, int m_b, int s_b>
constexpr Quantity<kg_a - kg_b, m_a - m_b, s_a - s_b> operator/(Quantity<kg_a, m_a, s_a> a,
                                                                Quantity<kg_b, m_b, s_b> b) {
    return {a.value / b.value};
}

// The units themselves, to be multiplied: 3.0 N is Newton{3.0}.
using One = Quantity<0, 0, 0>;
using Kilogram = Quantity<1, 0, 0>;
using Metre = Quantity<0, 1, 0>;
using Second = Quantity<0, 0, 1>;
using PerSecond = Quantity<0, 0, -1>;
using MetrePerSecond = Quantity<0, 1, -1>;
using MetrePerSecond2 = Quantity<0, 1, -2>;
using Newton = Quantity<1, 1, -2>;
using NewtonMetre = Quantity<1, 2, -2>;  // of a torque, and of work
using Watt = Quantity<1, 2, -3>;

// Whether an expression is in this unit.
template <class Unit, class Other>
constexpr bool is(Other) {
    return std::same_as<Unit, Other>;
}

template <class A, class B>
concept can_add = requires(A a, B b) {
    a + b;
};
template <class A, class B>
concept can_subtract = requires(A a, B b) {
    a - b;
};

}  // namespace pushfactor::tests::units
