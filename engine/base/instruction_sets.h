// Functions compiled once per instruction set, of which the processor's own is chosen at the start of the program.
// The results have the same bits: nothing is contracted, and every order of summation is written down. Such a
// function sees arrays only, because Eigen is compiled for one instruction set.
#pragma once

#if defined(__x86_64__) && defined(__linux__)
#define PUSHFACTOR_FOR_EACH_INSTRUCTION_SET [[gnu::target_clones("avx2", "default")]]
#else
#define PUSHFACTOR_FOR_EACH_INSTRUCTION_SET
#endif

namespace pushfactor::engine {

using Two [[gnu::vector_size(16), gnu::may_alias]] = double;
using Four [[gnu::vector_size(32), gnu::may_alias]] = double;

// Numbers at any address, to and from registers.
template <typename Vector>
[[gnu::always_inline]] inline void load(const double* from, Vector& vector) {
    __builtin_memcpy(&vector, from, sizeof vector);
}
template <typename Vector>
[[gnu::always_inline]] inline void store(const Vector& vector, double* to) {
    __builtin_memcpy(to, &vector, sizeof vector);
}

// Six numbers, in registers.
struct Six {
    Four upper;
    Two lower;

    [[gnu::always_inline]] inline explicit Six(const double* from) {
        load(from, upper);
        load(from + 4, lower);
    }
    [[gnu::always_inline]] inline void store(double* to) const {
        engine::store(upper, to);
        engine::store(lower, to + 4);
    }
    [[gnu::always_inline]] inline void add(double factor, const Six& other) {
        upper += factor * other.upper, lower += factor * other.lower;
    }
    [[gnu::always_inline]] inline void subtract(double factor, const Six& other) {
        upper -= factor * other.upper, lower -= factor * other.lower;
    }
};

}  // namespace pushfactor::engine
