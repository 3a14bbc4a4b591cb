#pragma once

#include <stdexcept>

namespace pushfactor::renderer {

// What everything in this folder throws. The message is one line that says what to do or where to look; only
// a shader compiler's message may span several.
class RendererError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace pushfactor::renderer
