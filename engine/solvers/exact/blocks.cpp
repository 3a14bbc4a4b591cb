#include "engine/solvers/exact/blocks.h"

#include "engine/base/instruction_sets.h"

#include <cmath>
#include <utility>

namespace pushfactor::engine::solvers::blocks {

namespace {

constexpr int side = 6;

[[gnu::always_inline]] inline Four& four(double* at) {
    return *reinterpret_cast<Four*>(at);
}
[[gnu::always_inline]] inline const Four& four(const double* at) {
    return *reinterpret_cast<const Four*>(at);
}

// Two columns of six numbers fill three vectors: `both` has rows 4 and 5 of the first, and rows 0 and 1 of the
// second.
struct TwoColumns {
    Four first, both, second;

    // The column `v`, twice.
    [[gnu::always_inline]] inline static TwoColumns of(const double* v) {
        return {four(v), Four{v[4], v[5], v[0], v[1]}, four(v + 2)};
    }
    [[gnu::always_inline]] inline TwoColumns times(double x, double y) const {
        return {first * x, both * Four{x, x, y, y}, second * y};
    }
};

// Sets entry k without a detour through memory.
template <int k>
[[gnu::always_inline]] inline void set(Six& column, double value) {
    if constexpr (k < 4) column.upper[k] = value;
    if constexpr (k >= 4) column.lower[k - 4] = value;
}

// Exchanges column k with the one whose entry in row k is the largest, and eliminates that row: column k becomes
// that of the inverse.
template <int k>
[[gnu::always_inline]] inline void eliminate(double* a, int& pivot) {
    pivot = k;
    for (int j = k + 1; j < side; ++j) {
        if (std::abs(a[k + j * side]) > std::abs(a[k + pivot * side])) pivot = j;
    }
    Six own = Six::at(a + pivot * side);
    const double to_unit = 1.0 / a[k + pivot * side];
    if (pivot != k) Six::at(a + k * side).store(a + pivot * side);
    set<k>(own, 1.0);
    own.upper *= to_unit, own.lower *= to_unit;
    for (int j = 0; j < side; ++j) {
        if (j == k) continue;
        Six other = Six::at(a + j * side);
        const double share = a[k + j * side];
        set<k>(other, 0.0);
        other.subtract(share, own);
        other.store(a + j * side);
    }
    own.store(a + k * side);
}

// c -= a b, with b_kj at b[k along_k + j along_j].
[[gnu::always_inline]] inline void subtract(double* c, const double* a, const double* b, int along_k, int along_j) {
#pragma GCC unroll 1
    for (int j = 0; j < side; j += 2, c += 2 * side) {
        Four first = four(c), both = four(c + 4), second = four(c + 8);
#pragma GCC unroll 6
        for (int k = 0; k < side; ++k) {
            const double* const of = b + k * along_k + j * along_j;
            const TwoColumns product = TwoColumns::of(a + k * side).times(of[0], of[along_j]);
            first -= product.first, both -= product.both, second -= product.second;
        }
        four(c) = first, four(c + 4) = both, four(c + 8) = second;
    }
}

}  // namespace

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void add_outer(double* a, double w, const double* v, const double* u) {
    const TwoColumns twice = TwoColumns::of(v).times(w, w);
    for (int j = 0; j < side; j += 2, a += 2 * side) {
        const TwoColumns product = twice.times(u[j], u[j + 1]);
        four(a) += product.first, four(a + 4) += product.both, four(a + 8) += product.second;
    }
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void add_difference(double* a, double w, const double* v, const double* u, const double* v_2, const double* u_2) {
    const TwoColumns twice = TwoColumns::of(v).times(w, w), twice_2 = TwoColumns::of(v_2).times(w, w);
    for (int j = 0; j < side; j += 2, a += 2 * side) {
        const TwoColumns plus = twice.times(u[j], u[j + 1]), minus = twice_2.times(u_2[j], u_2[j + 1]);
        four(a) += plus.first - minus.first;
        four(a + 4) += plus.both - minus.both;
        four(a + 8) += plus.second - minus.second;
    }
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void add_transposed(double* a, const double* b) {
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) a[i + j * side] += b[j + i * side];
    }
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void subtract_product(double* c, const double* a, const double* b) {
    subtract(c, a, b, 1, side);
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void subtract_product_with_transposed(double* c, const double* a, const double* b) {
    subtract(c, a, b, side, 1);
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void multiply(double* c, const double* a) {
    double product[side * side] = {};
    subtract(product, a, c, 1, side);
    for (int i = 0; i < side * side; ++i) c[i] = -product[i];
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void multiply_with_transposed(double* c, const double* a) {
    double product[side * side] = {};
    subtract(product, c, a, side, 1);
    for (int i = 0; i < side * side; ++i) c[i] = -product[i];
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void subtract_times(double* y, const double* a, const double* x) {
    Four of_even = {}, of_both = {}, of_odd = {};
    for (int j = 0; j < side; j += 2, a += 2 * side) {
        of_even += four(a) * x[j];
        of_both += four(a + 4) * Four{x[j], x[j], x[j + 1], x[j + 1]};
        of_odd += four(a + 8) * x[j + 1];
    }
    y[0] -= of_even[0] + of_both[2];
    y[1] -= of_even[1] + of_both[3];
    y[2] -= of_even[2] + of_odd[0];
    y[3] -= of_even[3] + of_odd[1];
    y[4] -= of_both[0] + of_odd[2];
    y[5] -= of_both[1] + of_odd[3];
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void subtract_transposed_times(double* y, const double* a, const double* x) {
    const TwoColumns twice = TwoColumns::of(x);
    for (int j = 0; j < side; j += 2, a += 2 * side) {
        const Four even = four(a) * twice.first, both = four(a + 4) * twice.both, odd = four(a + 8) * twice.second;
        y[j] -= ((even[0] + even[2]) + both[0]) + ((even[1] + even[3]) + both[1]);
        y[j + 1] -= ((odd[0] + odd[2]) + both[2]) + ((odd[1] + odd[3]) + both[3]);
    }
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void invert(double* a) {
    int exchanged[side];
    eliminate<0>(a, exchanged[0]);
    eliminate<1>(a, exchanged[1]);
    eliminate<2>(a, exchanged[2]);
    eliminate<3>(a, exchanged[3]);
    eliminate<4>(a, exchanged[4]);
    eliminate<5>(a, exchanged[5]);
    for (int k = side; k-- > 0;) {
        if (exchanged[k] == k) continue;
        for (int j = 0; j < side; ++j) std::swap(a[k + j * side], a[exchanged[k] + j * side]);
    }
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void invert_factor(double* a) {
    double inverse[side * side] = {};
    for (int j = 0; j < side; ++j) {
        double* const column = a + j * side;
        for (int k = 0; k < j; ++k) {
            for (int i = j; i < side; ++i) column[i] -= a[i + k * side] * a[j + k * side];
        }
        const double to_unit = 1.0 / std::sqrt(column[j]);
        for (int i = j; i < side; ++i) column[i] *= to_unit;
        inverse[j + j * side] = to_unit;
        for (int k = 0; k < j; ++k) {
            double sum = 0.0;
            for (int i = k; i < j; ++i) sum += a[j + i * side] * inverse[i + k * side];
            inverse[j + k * side] = -to_unit * sum;
        }
    }
    for (int i = 0; i < side * side; ++i) a[i] = inverse[i];
}

}  // namespace pushfactor::engine::solvers::blocks
