// The one exception for input that the engine cannot take.
#pragma once

#include <stdexcept>
#include <string>

namespace pushfactor::engine {

// what() reads "<field> <value>: must be <allowed>".
class InvalidInput : public std::invalid_argument {
  public:
    InvalidInput(const std::string& field, const std::string& value, const std::string& allowed)
        : std::invalid_argument(field + " " + value + ": must be " + allowed) {}
};

}  // namespace pushfactor::engine
