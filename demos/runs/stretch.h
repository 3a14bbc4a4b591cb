// Relative length errors of the distances of a scene.
#pragma once

#include "demos/runs/scene.h"

namespace pushfactor::demos {

// The largest error of a bar, rope or strut relative to its length, or of a joint relative to the size of its
// bodies. A slack rope has none; springs and distances with a force limit are left out, because they yield.
double worst_stretch(const BuiltScene& scene);

}  // namespace pushfactor::demos
