// Verdicts of a check as files that CI servers read: JUnit XML and Markdown.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <span>
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

// Follows the schemas of Jenkins' xUnit plugin (junit-10.xsd) and of Ant (JUnit.xsd). `time` is that of the run.
std::string junit_xml(std::span<const SuiteVerdict> suites, std::time_t time);

// GitHub's Markdown: the headline, a table of the suites, and one of the failures, the worst first. What would
// exceed `most_bytes` is left out, and it says so; GitHub takes 1 MiB per step.
std::string job_summary(const std::string& headline, std::span<const SuiteVerdict> suites,
                        std::size_t most_bytes = 500'000);

}  // namespace pushfactor::demos
