// The median of some numbers.
#pragma once

#include <algorithm>
#include <vector>

namespace pushfactor::demos {

// The middle of the sorted values, the mean of the two middle ones for an even number; 0 for none.
inline double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace pushfactor::demos
