// The parameters of scenes: one table per scene, and the given values.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

namespace pushfactor::demos {

struct Parameter {
    std::string_view name;  // without the leading dashes
    std::string_view placeholder;
    std::string_view help;
    double fallback = 0.0;         // value when not given
    double low = 0.0, high = 0.0;  // allowed, both included
    bool whole = false;

    std::string allowed() const;  // completes "must be ..."
};

class ParameterValues {
  public:
    explicit ParameterValues(std::span<const Parameter> parameters) : parameters_(parameters) {}

    // False and no change if the text is not a number in the range of `parameter`.
    bool set(const Parameter& parameter, std::string_view text);

    bool given(std::string_view name) const { return values_.contains(name); }
    double number(std::string_view name) const;  // the value given, or the fallback
    int whole(std::string_view name) const { return static_cast<int>(number(name)); }

  private:
    std::span<const Parameter> parameters_;
    std::map<std::string_view, double> values_;
};

}  // namespace pushfactor::demos
