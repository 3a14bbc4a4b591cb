// The command line of the program.
#pragma once

#include "demos/commands/commands.h"

#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos {

// A command with what it reads, and the files that it will write, some in folders.
struct CommandLine {
    commands::AnyCommand command;
    std::vector<NamedFile> outputs, folders;
};

std::vector<commands::Entry> command_entries();

// All commands with their options, from the tables of the help texts: the page demos/REFERENCE.md.
std::string reference_text();

// The words after the program's name. None after printing help or the version. Throws UsageError.
std::optional<CommandLine> parse_command_line(const std::vector<std::string>& words);

}  // namespace pushfactor::demos
