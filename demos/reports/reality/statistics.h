// Means with their errors, and shares with their confidence.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

namespace pushfactor::demos::reports::reality {

struct Mean {
    double value = 0.0, error = 0.0;  // one standard deviation of the mean
};
inline Mean mean_of(const std::vector<double>& values) {
    Mean mean;
    const auto count = static_cast<double>(values.size());
    if (values.empty()) return mean;
    for (const double value : values) mean.value += value / count;
    if (values.size() < 2) return mean;
    double squares = 0.0;
    for (const double value : values) squares += (value - mean.value) * (value - mean.value);
    mean.error = std::sqrt(squares / (count * (count - 1.0)));
    return mean;
}

// Of a share of `count` trials, the interval that has it with 95 % (Wilson 1927).
inline std::pair<double, double> confidence(double share, int count) {
    constexpr double z = 1.96;
    const double n = count, middle = share + z * z / (2.0 * n);
    const double reach = z * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
    return {(middle - reach) / (1.0 + z * z / n), (middle + reach) / (1.0 + z * z / n)};
}

}  // namespace pushfactor::demos::reports::reality
