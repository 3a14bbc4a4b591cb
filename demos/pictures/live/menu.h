// What a page in a browser has to choose from.
#pragma once

#include "demos/text/json.h"

namespace pushfactor::demos::pictures::live {

// The scenes with their parameters, the presets, the options of a simulation with what they allow, what the arrows
// mean, version and build.
Json menu();

}  // namespace pushfactor::demos::pictures::live
