// One function object of several, for std::visit: an alternative that none of them takes does not compile.
#pragma once

namespace pushfactor::engine {

template <typename... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};

}  // namespace pushfactor::engine
