#include "demos/pages/junit.h"

#include "demos/pages/html.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace pushfactor::demos {

namespace {

// XML has no control characters but these, not even escaped.
bool is_allowed(char c) {
    return static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t';
}

// In attributes a line's end has to be written as a number.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char& c : text) {
        if (is_allowed(c)) result += c == '\n' ? "&#10;" : html::escaped({&c, 1});
    }
    return result;
}

std::string case_xml(const SuiteVerdict& suite, const CaseVerdict& one) {
    const std::string start = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\"",
                                          escaped(suite.name), escaped(one.name));
    if (one.failure.empty()) return start + "/>\n";
    return fmt::format("{}>\n      <failure type=\"difference\" message=\"{}\">{}</failure>\n    </testcase>\n",
                       start, escaped(one.failure), escaped(one.failure));
}

}  // namespace

std::string junit_xml(std::span<const SuiteVerdict> suites, std::time_t time) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    const std::string timestamp = fmt::format("{:%Y-%m-%dT%H:%M:%S}", fmt::gmtime(time));
    int id = 0;
    for (const SuiteVerdict& suite : suites) {
        text += fmt::format(
            "  <testsuite name=\"{}\" package=\"pushfactor\" id=\"{}\" timestamp=\"{}\" hostname=\"localhost\" "
            "tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"0\" time=\"{:.3f}\">\n    <properties/>\n",
            escaped(suite.name), id++, timestamp, suite.cases.size(), suite.failures(), suite.seconds);
        for (const CaseVerdict& one : suite.cases) text += case_xml(suite, one);
        text += "    <system-out/>\n    <system-err/>\n  </testsuite>\n";
    }
    return text + "</testsuites>\n";
}

}  // namespace pushfactor::demos
