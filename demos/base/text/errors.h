// Errors of the program: one exception type per exit status (see FORMATS.md).
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace pushfactor::demos {

enum ExitStatus { done = 0, run_failed = 1, bad_usage = 2, check_failed = 3, output_failed = 4, not_finite = 5 };

// The message is a text, or what a format makes of its parts.
template <ExitStatus status>
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;

    template <typename... Parts>
    explicit Error(fmt::format_string<Parts...> format, Parts&&... parts) requires(sizeof...(Parts) > 0)
        : std::runtime_error(fmt::format(format, std::forward<Parts>(parts)...)) {}
};

using RunError = Error<run_failed>;  // the run failed or was interrupted
// One line that names the option or field, the value, and what is allowed.
using UsageError = Error<bad_usage>;
using CheckError = Error<check_failed>;    // a checked result is not as expected; names the first one
using OutputError = Error<output_failed>;  // an output could not be written; names it and says why
using NonFiniteError = Error<not_finite>;  // the simulation became non-finite; names body, quantity and step

}  // namespace pushfactor::demos
