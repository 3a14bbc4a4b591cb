#include "tests/peers/cost.h"

#include <algorithm>
#include <limits>

namespace pushfactor::tests::peers {

namespace {

// CPU times of the last `count` steps, in order of size.
std::vector<double> sorted(const Run& run, std::size_t count) {
    std::vector<double> times(run.step_us.end() - static_cast<std::ptrdiff_t>(std::min(count, run.step_us.size())),
                              run.step_us.end());
    std::sort(times.begin(), times.end());
    return times;
}

double median(const std::vector<double>& times) {
    return times.empty() ? std::numeric_limits<double>::quiet_NaN() : times[times.size() / 2];
}

Values median_and_worst(const std::vector<double>& times) {
    const double middle = median(times);
    return {{median_cost, middle, {}}, {"worst / median", times.empty() ? middle : times.back() / middle, {}}};
}

}  // namespace

Values whole_run(const Run& run) {
    return Values{Value{median_cost, median(sorted(run, run.step_us.size())), {}}};
}

Values last_seconds(const Run& run) {
    return Values{Value{"CPU, us a settled step", median(sorted(run, 300)), {}}};
}

Values median_and_worst(const Run& run) {
    return median_and_worst(sorted(run, run.step_us.size()));
}

Values median_and_worst_at_end(const Run& run) {
    return median_and_worst(sorted(run, 60));
}

}  // namespace pushfactor::tests::peers
