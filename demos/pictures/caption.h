// A run in one line of words.
#pragma once

#include "demos/options/choices.h"

#include <string>

namespace pushfactor::demos::pictures {

// The scene, the preset, and every option that differs from it: "stack   preset paper   beta 0.4". What is compared
// is left out, because the panels say it.
std::string caption_of(const Choices& choices);

}  // namespace pushfactor::demos::pictures
