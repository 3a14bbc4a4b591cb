// How far the distances of a scene are from their lengths.
#pragma once

#include "demos/runs/scene.h"

#include <vector>

namespace pushfactor::demos {

class Stretch {
  public:
    explicit Stretch(const BuiltScene& scene);

    // The largest error of a bar, rope or strut as a share of its length, of a joint as a share of the size of the
    // bodies that it holds. A slack rope has none, and those with a limit of their force are left out: they yield.
    double worst(const BuiltScene& scene) const;

  private:
    std::vector<double> scale_;  // m, one per distance; 0 leaves it out
};

}  // namespace pushfactor::demos
