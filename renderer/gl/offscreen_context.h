#pragma once

#include <memory>
#include <optional>
#include <string>

namespace pushfactor::renderer {

// A GL 3.3 (or later) core context without a window. To be used and destroyed on the thread that opened it, after
// all objects made in it.
//
// The default framebuffer has only a few pixels; draw into a framebuffer object.
class OffscreenContext {
  public:
    OffscreenContext() = default;
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;
    virtual ~OffscreenContext() = default;

    // Makes this context current on the calling thread. Throws RendererError.
    virtual void make_current() = 0;

    // Address of a GL function such as "glClear". May be non-null for unknown names: whether a function can be
    // called depends on the context's version.
    virtual void* function(const char* name) = 0;

    // The back end, for messages: "OSMesa" or "EGL".
    virtual std::string description() const = 0;

    // The library that was loaded for it, with its path.
    virtual std::string library() const = 0;
};

// OpenGL back ends.
enum class ContextKind { osmesa, egl };

// Opens a context of that kind, or of the first available kind, and makes it current. Both give byte-identical
// pictures with the same version of Mesa. Throws RendererError if none is available; the message names the packages
// to install.
std::unique_ptr<OffscreenContext> open_offscreen_context(std::optional<ContextKind> kind = std::nullopt);

// What draws: "4.5 (Core Profile) Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits)". Makes the context current. Throws
// RendererError if it is older than GL 3.3.
std::string gl_version_of(OffscreenContext& context);

}  // namespace pushfactor::renderer
