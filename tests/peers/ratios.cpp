#include "tests/peers/ratios.h"

#include <fmt/format.h>

#include <limits>

namespace pushfactor::tests::peers {

namespace {

double number(const Line& line, const std::string& measure) {
    for (const Value& value : line.values) {
        if (value.name == measure) return value.number;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

// "overlap, rms, mm" -> "overlap"
std::string short_name(const std::string& measure) {
    return measure.substr(0, measure.find(','));
}

}  // namespace

void append_ratios(const Case& of, std::vector<Line>& lines) {
    std::vector<Line> references;
    for (const Line& line : lines) {
        if (!line.reference.empty()) references.push_back(line);
    }
    for (Line& line : lines) {
        for (const std::string& measure : of.ratios) {
            for (const Line& reference : references)
                line.values.push_back({fmt::format("{} / {}", short_name(measure), reference.reference),
                                       number(line, measure) / number(reference, measure),
                                       {}});
        }
    }
}

}  // namespace pushfactor::tests::peers
