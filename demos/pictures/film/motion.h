// What the pictures of a run show of its motion: paths, ghosts, and the blur of an open shutter.
#pragma once

#include "demos/options/frame_options.h"
#include "demos/runs/simulation.h"
#include "renderer/picture/picture.h"

#include <deque>
#include <vector>

namespace pushfactor::demos::pictures {

// A run as it looked after a step.
struct Moment {
    double time = 0.0;  // s
    renderer::Picture picture;
};

// `count` pictures spread evenly over the time from `from` to `to` [s], in an order that has nothing to do with
// their number. Between two moments bodies are interpolated along lines and arcs; `moments` are by time, the last
// is at `to`.
std::vector<renderer::Picture> spread(const std::vector<Moment>& moments, double from, double to, int count);

class Motion {
  public:
    // `run` must outlive it. Throws UsageError for ghosts at times that are not steps of the run.
    Motion(const FrameChoices& choices, const Simulation& run);

    // Whether anything of a step is needed.
    bool wants_steps() const { return trail_ > 0.0 || open_ > 0.0 || !ghost_steps_.empty(); }

    // Called with the picture of each step, the start included.
    void note(const renderer::Picture& now);

    // Adds the ghosts so far, paler the older they are: bodies that have moved since.
    void add_ghosts(renderer::Picture& now) const;

    // Adds the paths of the centres of the bodies that move: lines that fade towards their past.
    void add_trails(renderer::Picture& now) const;

    // The steps while the shutter is open for a frame of now, and the one before; empty without a shutter.
    std::vector<Moment> while_open() const { return {moments_.begin(), moments_.end()}; }
    double open() const { return open_; }  // s of the run

  private:
    const Simulation& run_;
    double trail_;  // s
    double open_;   // s
    std::vector<long> ghost_steps_;
    std::vector<renderer::Picture> ghosts_;  // by time
    std::deque<Moment> moments_;
    struct Places {
        double time;
        std::vector<engine::Vector3> centres;  // of all bodies
    };
    std::deque<Places> path_;
};

}  // namespace pushfactor::demos::pictures
