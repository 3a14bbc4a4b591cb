#pragma once

#include <string>
#include <vector>

namespace pushfactor::renderer {

// A shared library loaded at run time: a program that only simulates starts without Mesa, and the GL symbols of
// such a library cannot clash with others.
class SharedLibrary {
  public:
    // Opens the first of `names` that exists. Never closed, because Mesa's threads and exit handlers live in it.
    // Throws RendererError if there is none: that `what` cannot be loaded, and what to do about it.
    SharedLibrary(const std::vector<std::string>& names, const std::string& what, const std::string& remedy);

    // Sets `function` to the library's function of this name; throws RendererError if it has none.
    template <typename Function>
    void find(const char* name, Function& function) const {
        function = reinterpret_cast<Function>(symbol(name));
    }

    // The file that was opened, with its path.
    std::string path() const;

  private:
    void* symbol(const char* name) const;

    void* handle_ = nullptr;
    std::string name_;
};

}  // namespace pushfactor::renderer
