#include "renderer/base/shared_library.h"

#include "renderer/base/renderer_error.h"

#include <dlfcn.h>
#include <link.h>

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

std::string SharedLibrary::path() const {
    link_map* map = nullptr;
    return dlinfo(handle_, RTLD_DI_LINKMAP, &map) == 0 ? map->l_name : name_;
}

void* SharedLibrary::symbol(const char* name) const {
    void* const found = dlsym(handle_, name);
    if (found == nullptr) throw RendererError(name_ + " has no " + name);
    return found;
}

}  // namespace pushfactor::renderer
