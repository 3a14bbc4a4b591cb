#include "demos/runs/session.h"

#include "demos/base/platform/processors.h"

namespace pushfactor::demos {

std::size_t Sequence::drawn_count() const {
    const auto count = static_cast<std::size_t>(shard.count);
    return (frame_count() + count - static_cast<std::size_t>(shard.number)) / count;
}

long Sequence::last_step(std::size_t panel) const {
    return frames[panel].are_stills() ? frames[panel].back().step : whole_steps(panels[panel].choices.settings);
}

Sequence plan_sequence(const std::string& scene, const GivenOptions& given) {
    Sequence sequence{.panels = compared_runs(scene, given), .frames = {}};
    for (const ComparedRun& panel : sequence.panels) {
        const Choices& choices = panel.choices;
        const Rational& dt = choices.settings.dt;
        const Frames& frames =
            sequence.frames.emplace_back(plan_frames(choices.frames, dt, whole_steps(choices.settings)));
        const std::vector<long> ghosts = plan_ghosts(choices.frames, dt);
        if (!ghosts.empty() && ghosts.back() > frames.back().step) {
            throw UsageError("--ghosts {}: must not be after the last picture, which is at {} s",
                             to_text(dt * Rational{ghosts.back(), 1}),
                             to_text(dt * Rational{frames.back().step, 1}));
        }
        if (sequence.frames.back().size() != sequence.frame_count()) {
            throw UsageError("--compare {}: the panels must have equally many frames, not {} and {}", panel.label,
                             sequence.frame_count(), sequence.frames.back().size());
        }
    }
    return sequence;
}

Session::Session(Sequence sequence, bool timing, GoTo go_to, std::vector<BuiltScene> built)
    : sequence_(std::move(sequence)), go_to_(std::move(go_to)) {
    for (std::size_t i = 0; i < sequence_.panels.size(); ++i) {
        const Choices choices = timing ? sequence_.panels[i].choices.on_one_thread() : sequence_.panels[i].choices;
        BuiltScene scene = i < built.size() ? std::move(built[i]) : build_scene(choices);
        scene.view = choices.description.view;
        runs_.emplace_back(std::move(scene), choices.settings, timing ? thread_cpu_us : nullptr);
    }
}

bool Session::bring(std::size_t panel, long step, const std::vector<Observer*>& observers, const GoesOn& goes_on) {
    Simulation& run = runs_[panel];
    while (run.sample().step < step || go_to_) {
        if (!goes_on(run)) return false;
        try {
            if (go_to_) {
                go_to_(run, step);
            } else {
                run.advance();
            }
        } catch (const NonFiniteError& error) {
            std::string message = error.what();
            for (Observer* const observer : observers) message += observer->failed(panel);
            throw NonFiniteError(message);
        }
        for (Observer* const observer : observers) observer->step(panel);
        if (go_to_) break;
    }
    return true;
}

bool Session::play_frames(const std::vector<Observer*>& observers, const GoesOn& goes_on) {
    for (std::size_t number = 0; number < sequence_.frame_count(); ++number) {
        for (std::size_t panel = 0; panel < size(); ++panel) {
            if (!bring(panel, sequence_.frames[panel][number].step, observers, goes_on)) return false;
        }
        for (Observer* const observer : observers) observer->frame(number);
    }
    return true;
}

bool Session::play(const std::vector<Observer*>& observers, const GoesOn& goes_on) {
    if (!play_frames(observers, goes_on)) return false;
    for (std::size_t panel = 0; panel < size() && !go_to_; ++panel) {
        if (!bring(panel, sequence_.last_step(panel), observers, goes_on)) return false;
    }
    return true;
}

}  // namespace pushfactor::demos
