// The limit of the difference of two images that should be equal.
#pragma once

#include "renderer/images/difference.h"

namespace pushfactor::renderer {

// Other processors round some pixels on edges differently; more than that is a different picture.
inline bool same_to_the_eye(const ImageDifference& difference) {
    return difference.share_above(2) <= 0.002 && difference.share_above(16) <= 0.0002 &&
           difference.similarity() >= 50.0;
}

}  // namespace pushfactor::renderer
