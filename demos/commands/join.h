// render --join: the video of frames that many machines drew.
#pragma once

#include "demos/commands/request.h"

namespace pushfactor::demos::commands {

// Throws UsageError for folders of other films; RunError that lists what is missing.
void join(const Request& request);

}  // namespace pushfactor::demos::commands
