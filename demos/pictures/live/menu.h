// What a page in a browser has to choose from.
#pragma once

#include "demos/text/json.h"

#include <string_view>

namespace pushfactor::demos::pictures::live {

// The scenes with their parameters, the presets, the options of a simulation with what they allow, what the arrows
// mean, version and build.
Json menu();

// Whether the page has an option of a simulation: it steps as long as it is looked at, and on one thread.
bool is_on_menu(std::string_view option);

}  // namespace pushfactor::demos::pictures::live
