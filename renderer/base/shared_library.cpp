#include "renderer/base/shared_library.h"

#include "renderer/base/renderer_error.h"

#include <dlfcn.h>

namespace pushfactor::renderer {

SharedLibrary::SharedLibrary(const std::vector<std::string>& names, const std::string& what,
                             const std::string& remedy) {
    for (const std::string& name : names) {
        name_ = name;
        handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (handle_ != nullptr) return;
    }
    throw RendererError("cannot load " + what + ", which draws without a display: " + remedy);
}

void* SharedLibrary::symbol(const char* name) const {
    void* const found = dlsym(handle_, name);
    if (found == nullptr) throw RendererError(name_ + " has no " + name);
    return found;
}

}  // namespace pushfactor::renderer
