// Processors and memory of the process.
#pragma once

#include <filesystem>
#include <optional>

namespace pushfactor::demos {

// Those that the scheduler may place it on, at least 1.
int usable_cores();

// Processor time per time that its control group (version 2) may use, such as 1.5; absent without a limit. `files`
// has the groups, `own` names the process's, as in /proc/self/cgroup. The smallest limit of the group and those
// above it.
std::optional<double> processor_limit(const std::filesystem::path& files = "/sys/fs/cgroup",
                                      const std::filesystem::path& own = "/proc/self/cgroup");

// CPU time of this thread in us.
double thread_cpu_us();

// Bytes in use by all threads; none where the C library does not tell.
std::optional<double> heap_bytes();

}  // namespace pushfactor::demos
