#include "demos/base/platform/processors.h"

#include <sched.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pushfactor::demos {

namespace {

namespace fs = std::filesystem;

// "200000 100000": microseconds of processor time per microseconds; "max 100000" is no limit.
std::optional<double> limit_in(const fs::path& file) {
    std::ifstream stream(file);
    double time = 0, period = 0;
    if (stream >> time >> period && period > 0) return time / period;
    return std::nullopt;
}

}  // namespace

int usable_cores() {
    cpu_set_t set;
    CPU_ZERO(&set);
    return sched_getaffinity(0, sizeof set, &set) == 0 ? std::max(1, CPU_COUNT(&set)) : 1;
}

std::optional<double> processor_limit(const fs::path& files, const fs::path& own) {
    std::ifstream groups(own);
    std::string line;
    while (std::getline(groups, line) && !line.starts_with("0::/")) {
    }
    if (!line.starts_with("0::/")) return std::nullopt;
    std::optional<double> least;
    // A group of its own namespace is called "/", and may be written as a way out of it, "/../..".
    fs::path group = fs::path(line.substr(4)).lexically_normal();
    if (group.begin() != group.end() && *group.begin() == "..") group.clear();
    for (;; group = group.parent_path()) {
        const auto limit = limit_in(files / group / "cpu.max");
        if (limit) least = std::min(limit.value(), least.value_or(*limit));
        if (group.empty()) return least;
    }
}

double thread_cpu_us() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

std::optional<double> heap_bytes() {
#ifdef __GLIBC__
    const auto info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
#else
    return {};
#endif
}

}  // namespace pushfactor::demos
