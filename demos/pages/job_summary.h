// Verdicts as Markdown, for the summary that CI servers show of a job.
#pragma once

#include "demos/pages/verdicts.h"

#include <cstddef>
#include <span>
#include <string>

namespace pushfactor::demos {

// GitHub's Markdown: the headline, a table of the suites, and one of the failures, the worst first. What would
// exceed `most_bytes` is left out, and it says so; GitHub takes 1 MiB per step.
std::string job_summary(const std::string& headline, std::span<const SuiteVerdict> suites,
                        std::size_t most_bytes = 500'000);

}  // namespace pushfactor::demos
