// A quantity at a place in the world, as overlays show it.
#pragma once

#include "engine/base/math.h"

#include <cstddef>

namespace pushfactor::demos::pictures {

struct Quantity {
    engine::Vector3 place = engine::Vector3::Zero();  // m
    engine::Vector3 value = engine::Vector3::Zero();  // N, N m or m/s; of lines m
    std::size_t kind = 0;                             // index into the entries of the overlay's kind
};

}  // namespace pushfactor::demos::pictures
