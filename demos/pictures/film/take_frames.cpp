#include "demos/pictures/film/take_frames.h"

#include "demos/platform/channel.h"
#include "demos/platform/progress.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

#include <utility>

namespace pushfactor::demos::pictures {

namespace {

// Sends a snapshot per frame of the shard, which is empty without a film.
class Snapshots : public Observer {
  public:
    Snapshots(const Sequence& sequence, const Pictures& pictures, StageTimes* times, Channel<Snapshot>& moments)
        : sequence_(sequence), pictures_(pictures), watch_(times), moments_(moments) {}

    void step(std::size_t panel) override {
        if (pictures_.film) pictures_.film->note(panel);
    }

    void frame(std::size_t number) override {
        watch_.end("simulate");
        if (pictures_.replay) pictures_.replay->frame(number);
        watch_.end("replay");
        if (!sequence_.shard.takes(number)) return;
        Snapshot moment;
        if (pictures_.film) moment = pictures_.film->look(sequence_.frames.front()[number].name);
        watch_.end("look");
        moments_.send(std::move(moment));
        watch_.skip();
    }

  private:
    const Sequence& sequence_;
    Pictures pictures_;
    StageWatch watch_;
    Channel<Snapshot>& moments_;
};

}  // namespace

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
        throw UsageError(
            fmt::format("--overlay {}: must not be with --from-trajectory, which has poses only; without it each "
                        "shard simulates the run itself",
                        name_of(item.kind)));
    }
}

void take_frames(Session& session, Observer* recorder, const Pictures& pictures, FrameQueue& queue,
                 StageTimes* times, const std::function<void(long)>& progress) {
    constexpr std::size_t ahead = 2;
    Producer<Snapshot> moments(ahead, [&](Channel<Snapshot>& channel) {
        const ThreadWatch thread(times);
        Snapshots snapshots(session.sequence(), pictures, times, channel);
        std::vector<Observer*> observers{&snapshots};
        if (recorder) observers.insert(observers.begin(), recorder);
        session.play(observers, [&](const Simulation&) { return !interrupted() && !channel.is_closed(); });
    });
    long drawn = 0;
    while (const auto moment = moments.next()) {
        if (pictures.film) {
            renderer::Image image = queue.blank();
            pictures.film->draw(*moment, image);
            queue.send(moment->name, std::move(image));
        }
        progress(++drawn);
    }
    queue.flush();
}

}  // namespace pushfactor::demos::pictures
