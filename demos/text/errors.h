// Errors of the program: one exception type per exit status (see FORMATS.md).
#pragma once

#include <stdexcept>

namespace pushfactor::demos {

enum ExitStatus { done = 0, run_failed = 1, bad_usage = 2, check_failed = 3, output_failed = 4, not_finite = 5 };

// The message is one line that names the option or field, the value, and what is allowed.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// The run failed or was interrupted.
class RunError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// A checked result is not as expected. The message names the first one.
class CheckError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// An output could not be written. The message names it and says why.
class OutputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// The simulation became non-finite. The message names the body, the quantity and the step.
class NonFiniteError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace pushfactor::demos
