// How often a thread asks for memory. Eigen takes its memory from malloc and the standard library through operator
// new, which calls malloc: so malloc and its kin are counted. They are replaced in the program of the tests alone;
// the replacements add to two numbers of the thread and pass the call on.
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

// What this thread has asked for since it began; zero where nothing is counted.
Allocations allocations();

// Not where sanitizers bring a malloc of their own.
bool allocations_are_counted();

}  // namespace pushfactor::tests
