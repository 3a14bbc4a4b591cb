// Runs of a scene side by side, stepped once: every instant is shown to all that want it.
#pragma once

#include "demos/base/platform/progress.h"
#include "demos/base/text/errors.h"
#include "demos/base/text/shard.h"
#include "demos/options/comparison.h"
#include "demos/options/frame_options.h"
#include "demos/runs/simulation.h"

#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace pushfactor::demos {

// The runs of a session, and the frames at which all of them are looked at.
struct Sequence {
    std::vector<ComparedRun> panels;  // one, or those of a comparison
    std::vector<Frames> frames;       // per panel, equally many in each
    Shard shard{};                    // the frames that are drawn: every `count`-th

    const std::string& scene() const { return panels.front().choices.description.name; }
    std::size_t frame_count() const { return frames.front().size(); }
    std::size_t drawn_count() const;  // of the shard
    // A run ends with its last still.
    long last_step(std::size_t panel) const;
};

// The frames that these options ask for. Throws UsageError.
Sequence plan_sequence(const std::string& scene, const GivenOptions& given);

class Observer {
  public:
    virtual ~Observer() = default;
    // The run of this panel has taken a step.
    virtual void step(std::size_t /*panel*/) {}
    // All runs are at their frame of this number.
    virtual void frame(std::size_t /*number*/) {}
    // The run of this panel has become non-finite. Returns what the message of the error says besides.
    virtual std::string failed(std::size_t /*panel*/) { return ""; }
};

class Session {
  public:
    // Asked before each step of a run; false ends the session early.
    using GoesOn = std::function<bool(const Simulation& run)>;
    // Brings a run to a step, which is not before its last one.
    using GoTo = std::function<void(Simulation& run, long step)>;

    // The runs at their start; with `timing` each on one thread, whose CPU time is measured. With `go_to` they are
    // brought to their frames by it, not stepped. `built`: the scenes of the runs, where they have been built.
    explicit Session(Sequence sequence, bool timing = false, GoTo go_to = {}, std::vector<BuiltScene> built = {});

    const Sequence& sequence() const { return sequence_; }
    const Choices& choices(std::size_t panel) const { return sequence_.panels[panel].choices; }
    const Simulation& run(std::size_t panel) const { return runs_[panel]; }
    std::size_t size() const { return runs_.size(); }

    // Takes the runs to each frame. Returns whether they got to the last one.
    bool play_frames(const std::vector<Observer*>& observers, const GoesOn& goes_on);
    // And then to their last steps.
    bool play(const std::vector<Observer*>& observers, const GoesOn& goes_on);

  private:
    bool bring(std::size_t panel, long step, const std::vector<Observer*>& observers, const GoesOn& goes_on);

    Sequence sequence_;
    GoTo go_to_;
    std::deque<Simulation> runs_;  // observers keep their addresses
};

inline bool before_end(const Simulation& run) {
    return run.sample().step < whole_steps(run.settings());
}

// Steps one run while `goes_on` returns true, and calls the observers after each step.
template <typename GoesOn, typename... Observers>
void play(Simulation& run, const GoesOn& goes_on, Observers&... observers) {
    while (goes_on(run)) {
        run.advance();
        (observers.observe(run), ...);
    }
}

// Steps one run up to step number `steps`; `check` is called before each step.
template <typename... Observers>
void play_steps(Simulation& run, long steps, const StopCheck& check, Observers&... observers) {
    const auto goes_on = [&](const Simulation& now) {
        check();
        return now.sample().step < steps;
    };
    play(run, goes_on, observers...);
}

// The same to the end of the run. Stops and returns false if it becomes non-finite.
template <typename... Observers>
bool play_to_end(Simulation& run, const StopCheck& check, Observers&... observers) {
    try {
        play_steps(run, whole_steps(run.settings()), check, observers...);
    } catch (const NonFiniteError&) {
        return false;
    }
    return true;
}

}  // namespace pushfactor::demos
