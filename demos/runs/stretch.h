// Relative length errors of the distances of a scene.
#pragma once

#include "demos/runs/scene.h"

#include <vector>

namespace pushfactor::demos {

class Stretch {
  public:
    explicit Stretch(const BuiltScene& scene);

    // The largest error of a bar, rope or strut relative to its length, or of a joint relative to the size of its
    // bodies. A slack rope has none; distances with a force limit are left out, because they yield.
    double worst(const BuiltScene& scene) const;

  private:
    std::vector<double> scale_;  // m, one per distance; 0 leaves it out
};

}  // namespace pushfactor::demos
