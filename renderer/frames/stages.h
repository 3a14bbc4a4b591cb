#pragma once

namespace pushfactor::renderer {

// Stages of a frame, in order.
enum class Stage { plan, shadow, ground, bodies, read, smooth, marks };

// Observer that is notified of finished stages, for timing.
class Stages {
  public:
    virtual ~Stages() = default;

    // The stage, including its GL commands, ran since the last call or the beginning of the frame.
    virtual void end(Stage stage) = 0;
};

}  // namespace pushfactor::renderer
