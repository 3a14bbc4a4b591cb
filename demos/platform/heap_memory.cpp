#include "demos/platform/heap_memory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pushfactor::demos {

std::optional<double> heap_bytes() {
#ifdef __GLIBC__
    const auto info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
#else
    return {};
#endif
}

}  // namespace pushfactor::demos
