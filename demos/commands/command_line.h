// The command line of the program.
#pragma once

#include "demos/commands/request.h"

#include <optional>

namespace pushfactor::demos {

// Nothing when only help or the version was asked for; it is printed then. Throws UsageError.
std::optional<Request> parse_command_line(int argc, char** argv);

}  // namespace pushfactor::demos
