#include "demos/scenes/parameters.h"

#include "demos/base/text/numbers.h"

#include <cmath>
#include <stdexcept>

namespace pushfactor::demos {

std::string Parameter::allowed() const {
    return std::string(whole ? "a whole number" : "a number") + " from " + to_text(low) + " to " + to_text(high);
}

bool ParameterValues::set(const Parameter& parameter, std::string_view text) {
    const auto value = parse_number(text);
    if (!value || *value < parameter.low || *value > parameter.high) return false;
    if (parameter.whole && *value != std::floor(*value)) return false;
    values_[parameter.name] = *value;
    return true;
}

double ParameterValues::number(std::string_view name) const {
    if (const auto found = values_.find(name); found != values_.end()) return found->second;
    for (const Parameter& parameter : parameters_) {
        if (parameter.name == name) return parameter.fallback;
    }
    throw std::out_of_range("the scene has no parameter " + std::string(name));
}

}  // namespace pushfactor::demos
