#include "demos/platform/cpu_clock.h"

#include <ctime>

namespace pushfactor::demos {

double thread_cpu_us() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

}  // namespace pushfactor::demos
