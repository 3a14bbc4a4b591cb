// Which moments of a run are drawn, and how large.
#pragma once

#include "demos/rational.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

struct FrameChoices {
    int width = 1280, height = 720;  // pixels
    std::optional<Rational> fps;     // frames a simulated second; 60 when not given
    std::vector<Rational> at;        // s; stills instead of a sequence when not empty
};

struct FrameOption {
    std::string_view name;
    std::string_view placeholder;
    std::string_view help;
    std::string_view allowed;
    bool (*set)(FrameChoices& choices, std::string_view text);
    std::string (*get)(const FrameChoices& choices);  // empty when not given
};

std::span<const FrameOption> frame_options();

// A frame: after which step it is taken, and its file name.
struct Frame {
    long step = 0;
    std::string name;
};

// The frames of a run of `steps` steps of `dt`, in the order of time. Throws UsageError when a time is no whole
// number of steps (naming the rates or times that are) or lies beyond the end.
std::vector<Frame> plan_frames(const FrameChoices& choices, const Rational& dt, long steps);

// Steps between two frames at `fps`. Throws UsageError as plan_frames does.
long steps_a_frame(const Rational& fps, const Rational& dt);

}  // namespace pushfactor::demos
