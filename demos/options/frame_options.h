// Which moments of a run are drawn, and how.
#pragma once

#include "demos/options/camera_choice.h"
#include "demos/options/overlay_choice.h"
#include "demos/text/rational.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

// "push=none,persistent": the panels of one picture.
struct Comparison {
    std::string option;
    std::vector<std::string> values;  // at least two
};

struct FrameChoices {
    int width = 1280, height = 720;  // pixels
    int samples = 1;                 // drawings that a picture is the mean of
    std::optional<Rational> fps{};   // frames a second of the film; 60 when not given
    Rational play_speed{1, 1};       // simulated seconds in a second of the film
    std::vector<Rational> at{};      // s; stills instead of a sequence when not empty
    CameraChoice camera{};
    bool caption = true;  // scene, options and time, below
    std::vector<OverlayItem> overlay{};
    std::optional<Comparison> compare{};
    std::string gl{};  // what draws: osmesa or egl; empty is the first that there is

    Rational film_rate() const { return fps.value_or(Rational{60, 1}); }  // frames a second of the film
};

struct FrameOption {
    std::string_view name;
    std::string_view placeholder;
    std::string_view help;
    std::string allowed;
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

// Steps between two frames of a film with `fps` frames a second. Throws UsageError as plan_frames does.
long steps_a_frame(const Rational& fps, const Rational& dt, const Rational& play_speed = {1, 1});

}  // namespace pushfactor::demos
