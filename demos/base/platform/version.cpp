#include "demos/base/platform/version.h"

#include "demos/commit.h"  // written by the build (write_commit.cmake)

namespace pushfactor::demos {

std::string version_number() {
    return PUSHFACTOR_VERSION;
}

std::string version_text() {
    return PUSHFACTOR_VERSION ", commit " PUSHFACTOR_COMMIT;
}

std::string compile_flags() {
    return PUSHFACTOR_FLAGS;
}

}  // namespace pushfactor::demos
