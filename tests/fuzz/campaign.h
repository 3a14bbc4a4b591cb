// A campaign: many random scenes, judged on all cores.
#pragma once

#include "tests/fuzz/judge.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace pushfactor::tests {

struct Failure {
    std::uint64_t seed = 0;
    Verdict verdict;                // of the shrunk scene
    demos::SceneDescription scene;  // shrunk
};

struct Campaign {
    long judged = 0;
    long non_finite = 0;            // ended with a non-finite state (exit 5)
    std::vector<Failure> failures;  // by seed
};

// The scenes of the seeds first .. first + count - 1. `go_on` is called now and then in the calling thread, with
// the number of scenes judged so far; when it returns false, the running scenes are finished and the results so far
// returned.
Campaign judge_scenes(std::uint64_t first, long count, const std::function<bool(long)>& go_on);

// The smallest scene in which the claim of `verdict` still fails, for no more steps than that takes.
Failure shrunk(std::uint64_t seed, const demos::SceneDescription& scene, const Verdict& verdict);

}  // namespace pushfactor::tests
