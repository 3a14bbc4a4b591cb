// The caption of a frame.
#pragma once

#include "demos/options/choices.h"

#include <string>

namespace pushfactor::demos::pictures {

// The scene, the preset, and every option that differs from it: "stack   preset paper   beta 0.4". The compared
// option is left out: it is in the panels' labels.
std::string caption_of(const Choices& choices);

}  // namespace pushfactor::demos::pictures
