// Indices are int in records, where -1 stands for none, and std::size_t in containers.
#pragma once

#include <cstddef>

namespace pushfactor::engine {

constexpr std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

}  // namespace pushfactor::engine
