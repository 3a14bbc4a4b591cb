// Verdicts as JUnit XML, which CI servers read.
#pragma once

#include <ctime>
#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos {

struct JunitCase {
    std::string name;
    std::string failure{};  // one line; empty if it holds
    std::string output{};   // further lines, such as where to look
};

struct JunitSuite {
    std::string name;
    double seconds = 0.0;
    std::vector<JunitCase> cases{};
};

// Follows the schemas of Jenkins' xUnit plugin (junit-10.xsd) and of Ant (JUnit.xsd). `time` is that of the run.
std::string junit_xml(std::span<const JunitSuite> suites, std::time_t time);

}  // namespace pushfactor::demos
