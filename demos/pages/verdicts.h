// Verdicts of a check, for files that CI servers read.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace pushfactor::demos {

struct CaseVerdict {
    std::string name;
    std::string failure{};  // one line; empty if it holds
    std::string skipped{};  // why nothing was compared; empty if something was
    double seconds = 0.0;
    double badness = 0.0;  // failures with larger ones are listed first
};

struct SuiteVerdict {
    std::string name;
    double seconds = 0.0;
    std::vector<CaseVerdict> cases{};

    long skipped() const {
        return std::count_if(cases.begin(), cases.end(), [](const auto& one) { return !one.skipped.empty(); });
    }
    long failures() const {
        return std::count_if(cases.begin(), cases.end(), [](const auto& one) { return !one.failure.empty(); });
    }
};

}  // namespace pushfactor::demos
