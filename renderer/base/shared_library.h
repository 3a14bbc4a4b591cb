#pragma once

#include <string>
#include <vector>

namespace pushfactor::renderer {

// A shared library that is found at run time: a program that only simulates starts without Mesa, and the GL symbols
// that such a library exports clash with nobody's.
class SharedLibrary {
  public:
    // Opens the first of `names` that there is. It is never closed: Mesa's threads and exit handlers live in it.
    // Throws a RendererError when there is none: that `what` cannot be loaded, and what to do about it.
    SharedLibrary(const std::vector<std::string>& names, const std::string& what, const std::string& remedy);

    // Sets `function` to the library's function of this name; throws a RendererError when it has none.
    template <typename Function>
    void find(const char* name, Function& function) const {
        function = reinterpret_cast<Function>(symbol(name));
    }

  private:
    void* symbol(const char* name) const;

    void* handle_ = nullptr;
    std::string name_;
};

}  // namespace pushfactor::renderer
