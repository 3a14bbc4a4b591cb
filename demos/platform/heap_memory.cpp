#include "demos/platform/heap_memory.h"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace pushfactor::demos {

std::optional<double> heap_bytes() {
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33)
    const auto info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
#else
    return {};
#endif
}

}  // namespace pushfactor::demos
