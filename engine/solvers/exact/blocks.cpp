#include "engine/solvers/exact/blocks.h"

#include "engine/base/instruction_sets.h"

#include <cmath>
#include <utility>

namespace pushfactor::engine::solvers::blocks {

namespace {

constexpr int side = 6;

// Two columns of six numbers fill three vectors: `both` has rows 4 and 5 of the first, and rows 0 and 1 of the
// second.
struct TwoColumns {
    Four first, both, second;

    [[gnu::always_inline]] inline static TwoColumns at(const double* columns) {
        TwoColumns two;
        load(columns, two.first);
        load(columns + 4, two.both);
        load(columns + 8, two.second);
        return two;
    }
    // The column `v`, twice.
    [[gnu::always_inline]] inline static TwoColumns of(const double* v) {
        TwoColumns two;
        load(v, two.first);
        two.both = Four{v[4], v[5], v[0], v[1]};
        load(v + 2, two.second);
        return two;
    }
    [[gnu::always_inline]] inline void store(double* columns) const {
        engine::store(first, columns);
        engine::store(both, columns + 4);
        engine::store(second, columns + 8);
    }
    [[gnu::always_inline]] inline TwoColumns times(double x, double y) const {
        return {first * x, both * Four{x, x, y, y}, second * y};
    }
    [[gnu::always_inline]] inline TwoColumns times(const TwoColumns& other) const {
        return {first * other.first, both * other.both, second * other.second};
    }
    [[gnu::always_inline]] inline void add(const TwoColumns& other) {
        first += other.first, both += other.both, second += other.second;
    }
    [[gnu::always_inline]] inline void subtract(const TwoColumns& other) {
        first -= other.first, both -= other.both, second -= other.second;
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
    Six own(a + pivot * side);
    const double to_unit = 1.0 / a[k + pivot * side];
    if (pivot != k) Six(a + k * side).store(a + pivot * side);
    set<k>(own, 1.0);
    own.upper *= to_unit, own.lower *= to_unit;
    for (int j = 0; j < side; ++j) {
        if (j == k) continue;
        Six other(a + j * side);
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
        TwoColumns own = TwoColumns::at(c);
#pragma GCC unroll 6
        for (int k = 0; k < side; ++k) {
            const double* const of = b + k * along_k + j * along_j;
            own.subtract(TwoColumns::of(a + k * side).times(of[0], of[along_j]));
        }
        own.store(c);
    }
}

}  // namespace

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void add_outer(double* a, double w, const double* v, const double* u) {
    const TwoColumns twice = TwoColumns::of(v).times(w, w);
    for (int j = 0; j < side; j += 2, a += 2 * side) {
        TwoColumns own = TwoColumns::at(a);
        own.add(twice.times(u[j], u[j + 1]));
        own.store(a);
    }
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void add_difference(double* a, double w, const double* v, const double* u, const double* v_2, const double* u_2) {
    const TwoColumns twice = TwoColumns::of(v).times(w, w), twice_2 = TwoColumns::of(v_2).times(w, w);
    for (int j = 0; j < side; j += 2, a += 2 * side) {
        TwoColumns own = TwoColumns::at(a), difference = twice.times(u[j], u[j + 1]);
        difference.subtract(twice_2.times(u_2[j], u_2[j + 1]));
        own.add(difference);
        own.store(a);
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
    TwoColumns sum{};
    for (int j = 0; j < side; j += 2, a += 2 * side) sum.add(TwoColumns::at(a).times(x[j], x[j + 1]));
    y[0] -= sum.first[0] + sum.both[2];
    y[1] -= sum.first[1] + sum.both[3];
    y[2] -= sum.first[2] + sum.second[0];
    y[3] -= sum.first[3] + sum.second[1];
    y[4] -= sum.both[0] + sum.second[2];
    y[5] -= sum.both[1] + sum.second[3];
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void subtract_transposed_times(double* y, const double* a, const double* x) {
    const TwoColumns twice = TwoColumns::of(x);
    for (int j = 0; j < side; j += 2, a += 2 * side) {
        const auto& [even, both, odd] = TwoColumns::at(a).times(twice);
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
