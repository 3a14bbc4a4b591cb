#include "demos/pages/verdict_files.h"

#include "demos/base/text/html.h"
#include "demos/base/text/utf8.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string_view>

namespace pushfactor::demos {

namespace {

// XML has no control characters but these, and no noncharacters, not even escaped.
bool is_allowed(std::uint32_t code) {
    return (code >= 0x20 || code == '\n' || code == '\t') && code != 0xfffe && code != 0xffff;
}

// In attributes a line's end has to be written as a number.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char& c : utf8(text, is_allowed)) result += c == '\n' ? "&#10;" : html::escaped({&c, 1});
    return result;
}

std::string case_xml(const SuiteVerdict& suite, const CaseVerdict& one) {
    const std::string start = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"",
                                          escaped(suite.name), escaped(one.name), one.seconds);
    if (!one.skipped.empty()) {
        return fmt::format("{}>\n      <skipped message=\"{}\"/>\n    </testcase>\n", start, escaped(one.skipped));
    }
    if (one.failure.empty()) return start + "/>\n";
    return fmt::format("{}>\n      <failure type=\"difference\" message=\"{}\">{}</failure>\n    </testcase>\n",
                       start, escaped(one.failure), escaped(one.failure));
}

// A cell of a table, as text.
std::string cell(const std::string& text) {
    std::string result;
    for (const char c : utf8(text)) {
        if (std::string_view("|\\`*_<>[]#&~").find(c) != std::string_view::npos) result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result;
}

// Failures first, the worst of them first: a summary that is too long is cut.
std::vector<std::string> lines_of(std::span<const SuiteVerdict> suites) {
    std::multimap<double, std::string, std::greater<>> failures;  // by badness
    for (const SuiteVerdict& suite : suites) {
        for (const CaseVerdict& one : suite.cases) {
            if (one.failure.empty()) continue;
            failures.emplace(one.badness,
                             fmt::format("| {} | {} |", cell(suite.name + ": " + one.name), cell(one.failure)));
        }
    }
    std::vector<std::string> lines;
    if (!failures.empty()) lines = {"| failure | |", "|---|---|"};
    for (const auto& [badness, line] : failures) lines.push_back(line);
    if (!failures.empty()) lines.emplace_back();
    lines.insert(lines.end(), {"| | | checked | failed | not compared |", "|---|---|---|---|---|"});
    for (const SuiteVerdict& suite : suites) {
        lines.push_back(fmt::format(
            "| {} | {} | {} | {} | {} |", suite.failures() > 0 ? "❌" : (suite.skipped() > 0 ? "⚠️" : "✅"),
            cell(suite.name), std::ssize(suite.cases) - suite.skipped(), suite.failures(), suite.skipped()));
    }
    return lines;
}

}  // namespace

std::string junit_xml(std::span<const SuiteVerdict> suites, std::time_t time) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    const std::string timestamp = fmt::format("{:%Y-%m-%dT%H:%M:%S}", fmt::gmtime(time));
    int id = 0;
    for (const SuiteVerdict& suite : suites) {
        text += fmt::format(
            "  <testsuite name=\"{}\" package=\"pushfactor\" id=\"{}\" timestamp=\"{}\" hostname=\"localhost\" "
            "tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\" time=\"{:.3f}\">\n    <properties/>\n",
            escaped(suite.name), id++, timestamp, suite.cases.size(), suite.failures(), suite.skipped(),
            suite.seconds);
        for (const CaseVerdict& one : suite.cases) text += case_xml(suite, one);
        text += "    <system-out/>\n    <system-err/>\n  </testsuite>\n";
    }
    return text + "</testsuites>\n";
}

std::string job_summary(const std::string& headline, std::span<const SuiteVerdict> suites, std::size_t most_bytes) {
    constexpr std::string_view cut = "\n… and more, for which there is no room here.\n";
    std::string text = fmt::format("### {}\n\n", cell(headline));
    for (const std::string& line : lines_of(suites)) {
        if (text.size() + line.size() + 1 + cut.size() > most_bytes) return text + std::string(cut);
        text += line + "\n";
    }
    return text;
}

}  // namespace pushfactor::demos
