// Allocation counts per thread. Eigen allocates by malloc, the standard library by operator new, which calls
// malloc: so malloc and its relatives are counted. They are replaced only in the test program; the replacements add
// to two counters of the thread and forward the call.
#pragma once

#include <cstdint>

namespace pushfactor::tests {

struct Allocations {
    std::uint64_t count = 0;
    std::uint64_t bytes = 0;  // as asked for

    friend Allocations operator-(const Allocations& a, const Allocations& b) {
        return {a.count - b.count, a.bytes - b.bytes};
    }
};

// Allocations of this thread since it began; zero where nothing is counted.
Allocations allocations();

// False under sanitizers, which have their own malloc.
bool allocations_are_counted();

}  // namespace pushfactor::tests
