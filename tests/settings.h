// Settings without sleeping, for tests that judge how things stand and move.
#pragma once

#include "demos/options/settings.h"

namespace pushfactor::tests {

inline demos::Settings awake_settings(std::string_view preset) {
    demos::Settings settings = demos::preset_settings(preset);
    settings.rest = false;
    settings.threads = 1;  // tests run beside each other
    return settings;
}

}  // namespace pushfactor::tests
