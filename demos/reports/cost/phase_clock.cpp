#include "demos/reports/cost/phase_clock.h"

#include "demos/platform/cpu_clock.h"

#include <algorithm>
#include <vector>

namespace pushfactor::demos::reports::cost {

double clock_cost() {
    std::vector<double> costs(10001);
    double before = thread_cpu_us();
    for (double& cost : costs) {
        const double now = thread_cpu_us();
        cost = now - before;
        before = now;
    }
    const auto middle = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2);
    std::nth_element(costs.begin(), middle, costs.end());
    return *middle;
}

void PhaseClock::begin() {
    last_ = thread_cpu_us();
}

void PhaseClock::end(std::size_t stage) {
    const double now = thread_cpu_us();
    times_[stage] += now - last_ - cost_;
    last_ = now;
}

}  // namespace pushfactor::demos::reports::cost
