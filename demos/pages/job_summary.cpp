#include "demos/pages/verdict_files.h"
#include "demos/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

namespace {

// A cell of a table, as text.
std::string cell(const std::string& text) {
    std::string result;
    for (const char c : utf8(text)) {
        if (std::string_view("|\\`*_<>[]#&~").find(c) != std::string_view::npos) result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result;
}

struct Failure {
    const SuiteVerdict* suite;
    const CaseVerdict* one;
};

std::vector<Failure> worst_first(std::span<const SuiteVerdict> suites) {
    std::vector<Failure> failures;
    for (const SuiteVerdict& suite : suites) {
        for (const CaseVerdict& one : suite.cases) {
            if (!one.failure.empty()) failures.push_back({&suite, &one});
        }
    }
    std::stable_sort(failures.begin(), failures.end(),
                     [](const Failure& a, const Failure& b) { return a.one->badness > b.one->badness; });
    return failures;
}

std::vector<std::string> lines_of(std::span<const SuiteVerdict> suites) {
    // Failures first: a summary that is too long is cut.
    std::vector<std::string> lines;
    const std::vector<Failure> failures = worst_first(suites);
    if (!failures.empty()) lines = {"| failure | |", "|---|---|"};
    for (const Failure& failure : failures) {
        lines.push_back(fmt::format("| {} | {} |", cell(failure.suite->name + ": " + failure.one->name),
                                    cell(failure.one->failure)));
    }
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
