#include "demos/version.h"

#include "demos/commit.h"  // written by the build (write_commit.cmake)

namespace pushfactor::demos {

std::string version_text() {
    return PUSHFACTOR_VERSION ", commit " PUSHFACTOR_COMMIT;
}

}  // namespace pushfactor::demos
