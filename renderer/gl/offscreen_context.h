#pragma once

#include <memory>
#include <optional>
#include <string>

namespace pushfactor::renderer {

// A GL 3.3 (or later) core context without a window. It is used and destroyed on the thread that opened it,
// after everything that was made in it.
//
// The default framebuffer is not for drawing: it has a few pixels at most. Draw into a framebuffer object.
class OffscreenContext {
  public:
    OffscreenContext() = default;
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;
    virtual ~OffscreenContext() = default;

    // Makes this the context that GL calls of this thread go to. Throws RendererError.
    virtual void make_current() = 0;

    // The address of a GL function such as "glClear". A name that the context does not know may still give a
    // non-null address: the context's version is what says whether a function can be called.
    virtual void* function(const char* name) = 0;

    // The backend, for messages: "OSMesa" or "EGL".
    virtual std::string description() const = 0;
};

// What can open one.
enum class ContextKind { osmesa, egl };

// Opens a context of that kind, or of the first kind that this machine has, and makes it current. Both give the
// same pictures, to the byte, when they are of the same Mesa. Throws RendererError when there is none; the message
// names the packages to install.
std::unique_ptr<OffscreenContext> open_offscreen_context(std::optional<ContextKind> kind = std::nullopt);

}  // namespace pushfactor::renderer
