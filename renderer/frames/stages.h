#pragma once

namespace pushfactor::renderer {

// The stages of a frame, in their order.
enum class Stage { plan, shadow, ground, bodies, read, smooth, marks };

// Somebody who wants to know how long they take.
class Stages {
  public:
    virtual ~Stages() = default;

    // The stage, and all that it asked of GL, has been done since the last call, or since the frame began.
    virtual void end(Stage stage) = 0;
};

}  // namespace pushfactor::renderer
