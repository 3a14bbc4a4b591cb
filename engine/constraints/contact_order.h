// The order in which contacts become rows. The paper does not give one, and for a truncated sweep nothing decides
// more about how long a stack stands.
#pragma once

#include "engine/base/threads.h"
#include "engine/collision/detector.h"

#include <span>
#include <vector>

namespace pushfactor::engine {

enum class RowOrder {
    bottom_up,      // pairs by the height of their lower movable body; normal, tangent, tangent a point
    reverse,        // pairs in descending order of creation, points descending; normal, tangent, tangent
    creation,       // pairs in the order of creation; normal, tangent, tangent a point
    normals_first,  // bottom-up, all normals before all tangents
};

// One contact point: indices into the touches and into the points of its manifold.
struct ContactIndex {
    int touch = 0;
    int point = 0;
};

class ContactOrder {
  public:
    // All points of `touches` (ascending order of creation, as the detector gives them) in the named order; good
    // until the next call. Height is measured along world y, to a fraction of the size of a pair. `threads` share
    // the work; null: one thread.
    std::span<const ContactIndex> put(RowOrder order, std::span<const collision::Touch> touches,
                                      std::span<const Body> bodies, Threads* threads = nullptr);

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
