// The command line of the program.
#pragma once

#include "demos/commands/request.h"

#include <optional>

namespace pushfactor::demos {

// The parsed command line; none after printing help or the version. Throws UsageError.
std::optional<Request> parse_command_line(int argc, char** argv);

// A word of the command line as a shell takes it.
std::string quoted(const std::string& word);

}  // namespace pushfactor::demos
