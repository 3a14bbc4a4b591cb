// Verdicts as JUnit XML, which CI servers read.
#pragma once

#include "demos/pages/verdicts.h"

#include <ctime>
#include <span>
#include <string>

namespace pushfactor::demos {

// Follows the schemas of Jenkins' xUnit plugin (junit-10.xsd) and of Ant (JUnit.xsd). `time` is that of the run.
std::string junit_xml(std::span<const SuiteVerdict> suites, std::time_t time);

}  // namespace pushfactor::demos
