// Runs of other engines.
#pragma once

#include "tests/peers/engine.h"

#include <chrono>
#include <vector>

namespace pushfactor::tests::peers {

Run run_peer(const Setting& setting, const Scene& scene, std::size_t steps);

// The same run again for the clock: three times, unless that takes longer than 20 s.
template <typename Once>
std::vector<Run> repeated(const Once& once) {
    constexpr std::size_t repeats = 3;
    constexpr std::chrono::seconds enough(20);
    const auto begin = std::chrono::steady_clock::now();
    std::vector<Run> runs;
    do {
        runs.push_back(once());
    } while (runs.size() < repeats && std::chrono::steady_clock::now() - begin < enough);
    return runs;
}

}  // namespace pushfactor::tests::peers
