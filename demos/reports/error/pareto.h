// Which points nobody beats in both of two numbers.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pushfactor::demos::reports::error {

struct Trade {
    double error = 0.0;
    double work = 0.0;
};

// Indices of the points that no other point beats: no other has less of one without more of the other. In the order
// of rising error, of equal points the first.
std::vector<std::size_t> pareto_front(std::span<const Trade> points);

}  // namespace pushfactor::demos::reports::error
