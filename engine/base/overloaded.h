// Combines functions to one object for std::visit: an alternative that none of them accepts does not compile.
#pragma once

namespace pushfactor::engine {

template <typename... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace pushfactor::engine
