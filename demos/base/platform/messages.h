// Standard error. A message that cannot be written is lost; it never changes what the program does.
#pragma once

#include <string>
#include <string_view>

namespace pushfactor::demos {

void say(std::string_view text);

// "pushfactor: note: ...", one line.
void note(std::string_view text);

// The text with control characters as escapes: a message is one line whatever names are in it.
std::string one_line(std::string_view text);

// Opens /dev/null for each standard stream that is closed, so that no file takes its place.
void keep_standard_streams();

}  // namespace pushfactor::demos
