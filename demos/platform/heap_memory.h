// What the program holds of the heap.
#pragma once

#include <optional>

namespace pushfactor::demos {

// Bytes in use by all threads; none where the C library does not tell.
std::optional<double> heap_bytes();

}  // namespace pushfactor::demos
