// Frame options: which times of a run are drawn, and how.
#pragma once

#include "demos/base/text/rational.h"
#include "demos/options/look_choices.h"
#include "demos/options/option_table.h"

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
// Parses "push=none,single-frame". None for other text.
std::optional<Comparison> parse_comparison(std::string_view text);

struct FrameChoices {
    int width = 1280, height = 720;  // pixels
    int samples = 1;                 // renderings averaged per picture
    std::optional<Rational> fps{};   // frames per second of the film; 60 if not given
    Rational play_speed{1, 1};       // simulated seconds per second of the film
    std::vector<Rational> at{};      // s; stills instead of a sequence when not empty
    std::vector<Rational> ghosts{};  // s; the bodies at these times are in later pictures too
    double shutter = 0.0;            // share of a frame's time that its samples are spread over, 0..1
    CameraChoice camera{};
    bool caption = true;  // scene, options and time, below
    std::vector<OverlayItem> overlay{};
    std::optional<Comparison> compare{};
    std::string gl{};  // OpenGL back end, osmesa or egl; empty: the first available

    double aspect() const { return static_cast<double>(width) / height; }
    double trail_seconds() const;                                         // 0 without trails
    Rational film_rate() const { return fps.value_or(Rational{60, 1}); }  // frames per second of the film
};

// Outputs that a frame option serves.
enum FrameUse : unsigned {
    of_pictures = 1,    // frames and stills
    of_film = 2,        // a sequence of frames
    of_shutter = 4,     // pictures over a share of a frame's time
    of_trajectory = 8,  // --trajectory
    of_models = 16,     // --glb and --replay
    of_run = 32,        // of these, also in the command run
};

struct FrameOption : TextOption<FrameChoices> {
    unsigned uses = of_pictures;  // FrameUse
};

std::span<const FrameOption> frame_options();

// A frame: the step after which it is taken, and its file name.
struct Frame {
    long step = 0;
    std::string name;
};

// Frames by time: stills, or those of a film, which are not stored, because there may be millions.
class Frames {
  public:
    Frames() = default;
    Frames(std::vector<Frame> stills) : stills_(std::move(stills)), size_(stills_.size()) {}  // NOLINT: as a list
    Frames(long every, std::size_t size) : every_(every), size_(size) {}  // one each `every` steps, from the start

    std::size_t size() const { return size_; }
    bool are_stills() const { return !stills_.empty(); }
    Frame operator[](std::size_t n) const;
    long every() const { return every_; }  // steps per frame of a film
    Frame back() const { return (*this)[size_ - 1]; }
    bool has(std::string_view name) const;

  private:
    std::vector<Frame> stills_;
    long every_ = 0;
    std::size_t size_ = 0;
};

// The frames of a run of `steps` steps of `dt`, by time. Throws UsageError for a time that is not a whole number of
// steps (the message names rates or times that are) or is beyond the end.
Frames plan_frames(const FrameChoices& choices, const Rational& dt, long steps);

// The steps of the ghosts, in order. Throws UsageError as plan_frames does.
std::vector<long> plan_ghosts(const FrameChoices& choices, const Rational& dt);

// Steps per frame of a film with `fps` frames per second. Throws UsageError as plan_frames does.
long steps_a_frame(const Rational& fps, const Rational& dt, const Rational& play_speed = {1, 1});

}  // namespace pushfactor::demos
