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

// Vectors at any address, which may be part of an array of doubles.
using Two [[gnu::vector_size(16), gnu::may_alias, gnu::aligned(8)]] = double;
using Four [[gnu::vector_size(32), gnu::may_alias, gnu::aligned(8)]] = double;

// Six numbers, in registers.
struct Six {
    Four upper;
    Two lower;

    [[gnu::always_inline]] inline static Six at(const double* numbers) {
        return {*reinterpret_cast<const Four*>(numbers), *reinterpret_cast<const Two*>(numbers + 4)};
    }
    [[gnu::always_inline]] inline void store(double* numbers) const {
        *reinterpret_cast<Four*>(numbers) = upper;
        *reinterpret_cast<Two*>(numbers + 4) = lower;
    }
    [[gnu::always_inline]] inline void add(double factor, const Six& other) {
        upper += factor * other.upper, lower += factor * other.lower;
    }
    [[gnu::always_inline]] inline void subtract(double factor, const Six& other) {
        upper -= factor * other.upper, lower -= factor * other.lower;
    }
};

}  // namespace pushfactor::engine
