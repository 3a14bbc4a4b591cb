// Order in which contacts become rows. The paper gives none, and nothing has more influence on how long a stack
// stands under a truncated sweep.
#pragma once

#include "engine/collision/detector.h"

#include <span>
#include <vector>

namespace pushfactor::engine {

enum class RowOrder {
    bottom_up,      // pairs by the height of their lower movable body, those with a static body first; per point
                    // normal, tangent, tangent
    reverse,        // pairs in descending order of creation, points descending; normal, tangent, tangent
    creation,       // pairs in order of creation; per point normal, tangent, tangent
    normals_first,  // bottom-up, all normals before all tangents
};

// A contact point: indices into the touches and into the points of its manifold.
struct ContactIndex {
    int touch = 0;
    int point = 0;
};

class ContactOrder {
  public:
    // All points of `touches` (in order of creation, as from the detector) in the given order; valid until the
    // next call. Height is along `up` (unit length, world frame), rounded to a fraction of the size of the pair; if
    // `up` is zero, because there is no gravity, all heights are equal.
    std::span<const ContactIndex> put(RowOrder order, std::span<const collision::Touch> touches,
                                      std::span<const Body> bodies, const Vector3& up);

  private:
    struct Key {
        double height = 0.0;
        bool on_movable = false;
        int touch = 0;
    };
    static bool before(const Key& a, const Key& b);

    std::vector<Key> keys_;
    std::vector<ContactIndex> contacts_;
};

}  // namespace pushfactor::engine
