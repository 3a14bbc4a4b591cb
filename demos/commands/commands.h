// The commands of the program, one file each. All throw the exceptions of errors.h.
#pragma once

#include "demos/commands/request.h"

namespace pushfactor::demos::commands {

void list(const Request& request);
void scene(const Request& request);
void family(const Request& request);
void run(const Request& request);
void render(const Request& request);
void figures(const Request& request);
void report(const Request& request);
void check(const Request& request);

}  // namespace pushfactor::demos::commands
