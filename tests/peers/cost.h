// The cost of a run, from the CPU times of its steps. Only these figures differ when a run is repeated.
#pragma once

#include "tests/peers/measures.h"

namespace pushfactor::tests::peers {

inline constexpr const char* median_cost = "CPU, us a step";

Values whole_run(const Run& run);     // median step
Values last_seconds(const Run& run);  // median step of the last five seconds: settled

// Median step, and the worst one as a multiple of it: of the whole run, and of the last second.
Values median_and_worst(const Run& run);
Values median_and_worst_at_end(const Run& run);

}  // namespace pushfactor::tests::peers
