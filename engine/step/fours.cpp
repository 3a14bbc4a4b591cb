#include "engine/step/fours.h"

#include "engine/solvers/lanes.h"

namespace pushfactor::engine {

namespace {

using Lanes = FourContacts::Lanes;
using solvers::unrolled;
enum : int { of_body = 6 };

// The six numbers of four bodies, a static one having zeros.
template <typename Number>
struct Bodies {
    double still[of_body] = {};
    Number* of[FourContacts::count];

    [[gnu::always_inline]] inline Bodies(const FourContacts::Of& numbers, Number* all) {
        unrolled<FourContacts::count>([&](auto i) __attribute__((always_inline)) {
            const int number = numbers[i];
            of[i] = number < 0 ? still : all + of_body * number;
        });
    }
    [[gnu::always_inline]] inline void load(Lanes* to) const {
        unrolled<of_body / 2>([&](auto k) __attribute__((always_inline)) {
            Two pairs[FourContacts::count];
            unrolled<FourContacts::count>([&](auto i) __attribute__((always_inline)) {
                engine::load(of[i] + 2 * k, pairs[i]);
            });
            const Lanes even = __builtin_shufflevector(pairs[0], pairs[2], 0, 1, 2, 3);
            const Lanes odd = __builtin_shufflevector(pairs[1], pairs[3], 0, 1, 2, 3);
            to[2 * k] = __builtin_shufflevector(even, odd, 0, 4, 2, 6);
            to[2 * k + 1] = __builtin_shufflevector(even, odd, 1, 5, 3, 7);
        });
    }
    [[gnu::always_inline]] inline void store(const Lanes* from) const {
        unrolled<of_body / 2>([&](auto k) __attribute__((always_inline)) {
            const Lanes even = __builtin_shufflevector(from[2 * k], from[2 * k + 1], 0, 4, 2, 6);
            const Lanes odd = __builtin_shufflevector(from[2 * k], from[2 * k + 1], 1, 5, 3, 7);
            engine::store(__builtin_shufflevector(even, even, 0, 1), of[0] + 2 * k);
            engine::store(__builtin_shufflevector(odd, odd, 0, 1), of[1] + 2 * k);
            engine::store(__builtin_shufflevector(even, even, 2, 3), of[2] + 2 * k);
            engine::store(__builtin_shufflevector(odd, odd, 2, 3), of[3] + 2 * k);
        });
    }
};

// Both bodies of four contacts; twelve numbers, those of a first.
template <typename Number>
struct Pairs {
    Bodies<Number> a, b;

    [[gnu::always_inline]] inline Pairs(const FourContacts& four, Number* all) : a(four.a, all), b(four.b, all) {}
    [[gnu::always_inline]] inline void load(Lanes* to) const {
        a.load(to);
        b.load(to + of_body);
    }
    [[gnu::always_inline]] inline void store(const Lanes* from) const {
        a.store(from);
        b.store(from + of_body);
    }
};

[[gnu::always_inline]] inline void to_absolute(Lanes& value) {
    using Bits = decltype(value < value);
    value = reinterpret_cast<Lanes>(reinterpret_cast<Bits>(value) & 0x7fffffffffffffff);
}

[[gnu::always_inline]] inline void to_root(Lanes& value) {
    value = Lanes{__builtin_sqrt(value[0]), __builtin_sqrt(value[1]), __builtin_sqrt(value[2]),
                  __builtin_sqrt(value[3])};
}

// u . x in the order of solvers::products(), for both bodies.
[[gnu::always_inline]] inline void project(const Lanes* u, const Lanes* x, Lanes& sum) {
    const Lanes even = (u[0] * x[0] + u[6] * x[6]) + (u[2] * x[2] + u[8] * x[8]) + (u[4] * x[4] + u[10] * x[10]);
    const Lanes odd = (u[1] * x[1] + u[7] * x[7]) + (u[3] * x[3] + u[9] * x[9]) + (u[5] * x[5] + u[11] * x[11]);
    sum = even + odd;
}

// For one body, in the order of Eigen's dot().
[[gnu::always_inline]] inline void dot(const Lanes* u, const Lanes* x, Lanes& sum) {
    sum = (u[0] * x[0] + (u[2] * x[2] + u[4] * x[4])) + (u[1] * x[1] + (u[3] * x[3] + u[5] * x[5]));
}

// s u . d of the normals [m].
[[gnu::always_inline]] inline void find_way(const FourContacts& four, const double* d, Lanes& way) {
    Lanes moved[2 * of_body], by_a, by_b;
    Pairs(four, d).load(moved);
    dot(four.axis[0], moved, by_a);
    dot(four.axis[0] + of_body, moved + of_body, by_b);
    way = four.scale[0] * (by_a + by_b);
}

// Adds the changes `y` of all rows to the velocities.
[[gnu::always_inline]] inline void add(const FourContacts& four, const Lanes* y, Lanes* v) {
    unrolled<2 * of_body>([&](auto k) __attribute__((always_inline)) {
        v[k] = ((v[k] + four.axis[0][k] * y[0]) + four.axis[1][k] * y[1]) + four.axis[2][k] * y[2];
    });
}

// The share of a force that is in its disc.
[[gnu::always_inline]] inline void find_share(const Lanes& first, const Lanes& second, const Lanes& radius,
                                              Lanes& share) {
    const Lanes square = first * first + second * second;
    Lanes length = square;
    to_root(length);
    share = square > radius * radius ? radius / length : Lanes{} + 1.0;
}

// These see arrays only (instruction_sets.h).

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void sweep_some(FourContacts* some, FourContacts* end, double* x) {
    for (FourContacts* four = some; four != end; ++four) {
        const Pairs bodies(*four, x);
        Lanes v[2 * of_body], wanted[FourContacts::rows];
        bodies.load(v);
        unrolled<FourContacts::rows>([&](auto i) __attribute__((always_inline)) {
            project(four->axis[i], v, wanted[i]);
            wanted[i] = four->y[i] + (four->t[i] - wanted[i]);
        });
        Lanes changes[FourContacts::rows], largest{};
        const auto move = [&](int i, const Lanes& to) __attribute__((always_inline)) {
            const Lanes moved = four->acts ? to : four->y[i];
            changes[i] = moved - four->y[i];
            four->y[i] = moved;
            Lanes speed = changes[i];
            to_absolute(speed);
            speed *= four->scale[i];
            largest = largest < speed ? speed : largest;
        };
        const Lanes pressed = wanted[0] * four->keeps;
        move(0, pressed < 0.0 ? Lanes{} : pressed);
        const Lanes first = wanted[1] - four->coupling[0] * changes[0];
        const Lanes second = wanted[2] - four->coupling[1] * changes[0];
        Lanes share;
        find_share(first, second, four->radius * four->y[0], share);
        move(1, first * share);
        move(2, second * share);
        four->change = largest;
        add(*four, changes, v);
        bodies.store(v);
    }
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void aim_some(FourContacts* some, FourContacts* end, const Aim& aim, const double* d) {
    for (FourContacts* four = some; four != end; ++four) {
        if (!aim.pushes) {
            Lanes way;
            find_way(*four, d, way);
            four->error = four->start + way - aim.elapsed * four->carried;
        }
        const auto target = target_of(aim, four->error, four->beta, Lanes{} + 1.0, Lanes{} + aim.fastest);
        four->t[0] = four->holds ? (target.speed + four->carried) / four->scale[0] : four->t[0];
        four->keeps = four->holds ? target.keeps : four->keeps;
        four->acts = four->scale[0] > 0.0;
    }
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void add_up_some(FourContacts* some, FourContacts* end, bool pushes) {
    for (FourContacts* four = some; four != end; ++four) {
        Lanes* const sums = pushes ? four->pushing : four->lasting;
        unrolled<FourContacts::rows>([&](auto i) __attribute__((always_inline)) {
            sums[i] += four->y[i] / four->scale[i];
        });
    }
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void push_some(FourContacts* some, FourContacts* end, double* x) {
    for (FourContacts* four = some; four != end; ++four) {
        const Pairs bodies(*four, x);
        Lanes v[2 * of_body];
        bodies.load(v);
        add(*four, four->y, v);
        bodies.store(v);
    }
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void look_some(FourContacts* some, FourContacts* end, double* x) {
    for (FourContacts* four = some; four != end; ++four) {
        Lanes v[2 * of_body], moved[FourContacts::rows];
        Pairs(*four, x).load(v);
        unrolled<FourContacts::rows>([&](auto i) __attribute__((always_inline)) {
            project(four->axis[i], v, moved[i]);
            moved[i] = four->y[i] + (four->t[i] - moved[i]);
        });
        Lanes normal = (moved[0] < 0.0 ? Lanes{} : moved[0]) - four->y[0], share;
        find_share(moved[1], moved[2], four->radius * four->y[0], share);
        const Lanes first = moved[1] * share - four->y[1], second = moved[2] * share - four->y[2];
        Lanes across = first * first + second * second;
        to_root(across);
        to_absolute(normal);
        normal *= four->scale[0], across *= four->scale[2];
        four->change = normal < across ? across : normal;
    }
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void aim_some_apart(FourContacts* some, FourContacts* end, const Apart& apart, const double* d) {
    for (FourContacts* four = some; four != end; ++four) {
        Lanes way, left;
        find_way(*four, d, way);
        find_left(apart, four->start, way - apart.dt * four->carried, four->correcting, four->y[0] * four->scale[0],
                  left);
        four->t[0] = left / four->scale[0];
        four->y[0] = Lanes{};
    }
}

PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
void push_some_apart(FourContacts* some, FourContacts* end, double* d) {
    for (FourContacts* four = some; four != end; ++four) {
        const Pairs bodies(*four, d);
        Lanes v[2 * of_body], by_a, by_b;
        bodies.load(v);
        dot(four->axis[0], v, by_a);
        dot(four->axis[0] + of_body, v + of_body, by_b);
        const Lanes wanted = four->y[0] + (four->t[0] - by_a - by_b);
        const Lanes moved = four->holds ? wanted < 0.0 ? Lanes{} : wanted : four->y[0];
        const Lanes change = moved - four->y[0];
        four->y[0] = moved;
        unrolled<2 * of_body>([&](auto k) __attribute__((always_inline)) { v[k] += four->axis[0][k] * change; });
        bodies.store(v);
    }
}

}  // namespace

void aim(std::span<FourContacts> some, const Aim& aim, std::span<const Vector6> d) {
    if (!some.empty()) aim_some(some.data(), some.data() + some.size(), aim, d.front().data());
}

void sweep(std::span<FourContacts> some, std::span<Vector6> x) {
    if (!some.empty()) sweep_some(some.data(), some.data() + some.size(), x.front().data());
}

void add_up(std::span<FourContacts> some, bool pushes) {
    if (!some.empty()) add_up_some(some.data(), some.data() + some.size(), pushes);
}

void push(std::span<FourContacts> some, std::span<Vector6> x) {
    if (!some.empty()) push_some(some.data(), some.data() + some.size(), x.front().data());
}

void look(std::span<FourContacts> some, std::span<Vector6> x) {
    if (!some.empty()) look_some(some.data(), some.data() + some.size(), x.front().data());
}

void aim_apart(std::span<FourContacts> some, const Apart& apart, std::span<const Vector6> d) {
    if (!some.empty()) aim_some_apart(some.data(), some.data() + some.size(), apart, d.front().data());
}

void push_apart(std::span<FourContacts> some, std::span<Vector6> d) {
    if (!some.empty()) push_some_apart(some.data(), some.data() + some.size(), d.front().data());
}

}  // namespace pushfactor::engine
