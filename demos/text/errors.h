// Errors of the program: one exception type per exit status (see FORMATS.md).
#pragma once

#include <stdexcept>

namespace pushfactor::demos {

enum ExitStatus { done = 0, run_failed = 1, bad_usage = 2, check_failed = 3, output_failed = 4, not_finite = 5 };

// The message is one line that names the option or field, the value, and what is allowed.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The run failed or was interrupted.
struct RunError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A checked result is not as expected. The message names the first one.
struct CheckError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// An output could not be written. The message names it and says why.
struct OutputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The simulation became non-finite. The message names the body, the quantity and the step.
struct NonFiniteError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace pushfactor::demos
