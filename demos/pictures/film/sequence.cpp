#include "demos/pictures/film/sequence.h"

#include "demos/platform/producer.h"
#include "demos/platform/progress.h"
#include "demos/platform/version.h"
#include "demos/text/errors.h"
#include "demos/text/json.h"

#include <fmt/format.h>

#include <utility>

namespace pushfactor::demos::pictures {

namespace {

// Sends a snapshot per frame, which is empty without a film. Stops early when the channel is closed or the program
// is interrupted.
class Shooting {
  public:
    Shooting(const Sequence& sequence, std::vector<ObservedRun>& runs, Takers& takers, StageTimes* times)
        : sequence_(sequence), runs_(runs), takers_(takers), times_(times) {}

    void operator()(Channel<Snapshot>& moments) {
        const ThreadWatch thread(times_);
        const Frames& frames = sequence_.frames.front();
        for (std::size_t i = 0; takers_.film && i < runs_.size(); ++i) takers_.film->note(i);
        for (std::size_t frame = 0; frame < frames.size(); ++frame) {
            StageWatch watch(times_);
            for (std::size_t i = 0; i < runs_.size(); ++i) {
                if (!advance(i, sequence_.frames[i][frame].step, moments)) return;
            }
            watch.end("simulate");
            if (takers_.replay) takers_.replay->record();
            watch.end("replay");
            if (!sequence_.shard.takes(frame)) continue;
            Snapshot moment;
            if (takers_.film) moment = takers_.film->look(frames[frame].name);
            watch.end("look");
            if (!moments.send(std::move(moment))) return;
        }
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            if (!advance(i, sequence_.last_step(i), moments)) return;
        }
    }

  private:
    bool advance(std::size_t run, long step, const Channel<Snapshot>& moments) {
        while (runs_[run].simulation().sample().step < step) {
            if (interrupted() || moments.is_closed()) return false;
            runs_[run].advance();
            if (takers_.film) takers_.film->note(run);
        }
        return true;
    }

    const Sequence& sequence_;
    std::vector<ObservedRun>& runs_;
    Takers& takers_;
    StageTimes* times_;
};

}  // namespace

long Sequence::last_step(std::size_t panel) const {
    const Choices& choices = panels[panel].choices;
    return choices.frames.at.empty() ? whole_steps(choices.settings) : frames[panel].back().step;
}

std::size_t Sequence::drawn_count() const {
    const auto count = static_cast<std::size_t>(shard.count);
    return (frame_count() + count - static_cast<std::size_t>(shard.number)) / count;
}

void require_poses_only(const Sequence& sequence, const std::string& file) {
    const FrameChoices& frames = sequence.panels.front().choices.frames;
    if (sequence.panels.size() > 1) {
        throw UsageError(fmt::format("--from-trajectory {}: must be of one run, not with --compare", file));
    }
    for (const auto& [option, given] :
         {std::pair{"--ghosts", !frames.ghosts.empty()}, std::pair{"--shutter", frames.shutter > 0.0}}) {
        if (!given) continue;
        throw UsageError(
            fmt::format("{}: must not be with --from-trajectory, which takes no steps between frames", option));
    }
    for (const OverlayItem& item : frames.overlay) {
        if (item.kind == OverlayKind::no_contacts) continue;
        throw UsageError(fmt::format(
            "--overlay {}: must not be with --from-trajectory, which has poses only; without it each shard "
            "simulates the run itself",
            name_of(item.kind)));
    }
}

void draw_frames(const Sequence& sequence, Simulation& simulation, Trajectory& trajectory, const Film& film,
                 FrameQueue& queue, const std::function<void(long)>& progress) {
    long drawn = 0;
    const Frames& frames = sequence.frames.front();
    trajectory.place(simulation, 0);  // is it of this run?
    for (std::size_t i = 0; i < frames.size() && !interrupted(); ++i) {
        if (!sequence.shard.takes(i)) continue;
        trajectory.place(simulation, frames[i].step);
        renderer::Image image = queue.blank();
        film.draw(film.look(frames[i].name), image);
        queue.send(frames[i].name, std::move(image));
        progress(++drawn);
    }
    queue.flush();
}

Sequence plan_sequence(const std::string& scene, const GivenOptions& given) {
    Sequence sequence{.panels = compared_runs(scene, given), .frames = {}};
    for (const ComparedRun& panel : sequence.panels) {
        const Choices& choices = panel.choices;
        sequence.frames.push_back(plan_frames(choices.frames, choices.settings.dt, whole_steps(choices.settings)));
        if (sequence.frames.back().size() != sequence.frame_count()) {
            throw UsageError(fmt::format("--compare {}: the panels must have equally many frames, not {} and {}",
                                         panel.label, sequence.frame_count(), sequence.frames.back().size()));
        }
    }
    return sequence;
}

void take_frames(const Sequence& sequence, std::vector<ObservedRun>& runs, Takers& takers, FrameQueue& queue,
                 StageTimes* times, const std::function<void(long)>& progress) {
    constexpr std::size_t ahead = 2;
    Producer<Snapshot> moments(ahead, Shooting(sequence, runs, takers, times));
    long drawn = 0;
    while (const auto moment = moments.next()) {
        if (takers.film) {
            renderer::Image image = queue.blank();
            takers.film->draw(*moment, image);
            queue.send(moment->name, std::move(image));
        }
        progress(++drawn);
    }
    queue.flush();
}

std::string finish(const Sequence& sequence, std::vector<ObservedRun>& runs, const std::string& driver) {
    Json summary;
    if (runs.size() == 1) {
        summary = Json::parse(runs.front().finish());
    } else {
        summary["compare"] = sequence.panels.front().choices.frames.compare->option;
        for (ObservedRun& run : runs) summary["panels"].push_back(Json::parse(run.finish()));
    }
    summary["made_with"] = {{"program", version_text()}};
    if (!driver.empty()) summary["made_with"]["driver"] = driver;
    return json_text(summary);
}

}  // namespace pushfactor::demos::pictures
