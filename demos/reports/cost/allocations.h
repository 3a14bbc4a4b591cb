// How often a thread asks for memory. Eigen takes its memory from malloc and the standard library through operator
// new, which calls malloc: so it is malloc and its kin that are counted. They are replaced where a program is
// linked with this file and nowhere else, and what replaces them adds to two numbers of the thread and passes the
// call on.
#pragma once

#include <cstdint>

namespace pushfactor::demos::reports::cost {

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

}  // namespace pushfactor::demos::reports::cost
