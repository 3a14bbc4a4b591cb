#include "demos/pictures/gltf/glb_record.h"

#include "demos/pictures/camera/composition.h"
#include "demos/pictures/camera/framing.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/gltf/marks.h"
#include "demos/pictures/gltf/stage.h"
#include "demos/pictures/lettering.h"
#include "demos/pictures/overlays/overlay.h"
#include "demos/platform/output_file.h"
#include "demos/text/errors.h"

#include <fmt/format.h>

namespace pushfactor::demos::pictures {

namespace {

using namespace gltf;

// Up to here floats tell the times of neighbouring frames apart, at any frame rate.
constexpr long most_frames = 1L << 22;

bool can_move(const BodyDescription& body) {
    return body.mass || body.motion;
}

long steps_a_key(const Choices& choices) {
    return steps_a_frame(choices.frames.film_rate(), choices.settings.dt, choices.frames.play_speed);
}

View view_at_start(const Choices& choices, const Survey& survey, const BuiltScene& scene) {
    const View view = choices.frames.camera.view.value_or(scene.view);
    const double aspect = static_cast<double>(choices.frames.width) / choices.frames.height;
    return choices.frames.camera.fit ? composed(view, survey.subject, aspect) : view;
}

Json about(const Choices& choices) {
    return {{"run", caption_of(choices)},
            {"frames_per_second", json_of(to_text(choices.frames.film_rate()))},
            {"simulated_seconds_per_second", json_of(to_text(choices.frames.play_speed))}};
}

class GlbRecord : public Record {
  public:
    GlbRecord(const std::filesystem::path& file, const Choices& choices, const Survey& survey,
              const Simulation& start)
        : file_(file),
          every_(steps_a_key(choices)),
          fps_(choices.frames.film_rate().value()),
          camera_(choices.frames.camera),
          view_(view_at_start(choices, survey, start.scene())),
          marks_(choices.frames.overlay, survey, view_),
          document_(about(choices)) {
        const BuiltScene& scene = start.scene();
        const renderer::Picture picture = draw_list(scene, view_);
        const std::vector<int> nodes = add_bodies(scene, picture, document_);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (can_move(scene.bodies[i])) movers_.push_back({i, nodes[i]});
        }
        bar_nodes_ = add_bars(picture, document_);
        for (const renderer::Bar& bar : picture.bars) bar_stretches_.push_back(stretch_of(bar));
        const View first = turned(camera_, view_, start.sample().time);
        camera_node_ =
            add_camera(first, static_cast<double>(choices.frames.width) / choices.frames.height, document_);
        add_sun(picture, document_);
        observe(start);
    }

    void observe(const Simulation& simulation) override {
        if (simulation.sample().step % every_ != 0) return;
        const BuiltScene& scene = simulation.scene();
        poses_.clear();
        for (const Mover& mover : movers_) {
            const engine::Body& body = scene.world.bodies[mover.body];
            poses_.push_back({body.position, body.orientation});
        }
        if (camera_.degrees_a_second != 0.0) {
            poses_.push_back(pose_of(turned(camera_, view_, simulation.sample().time)));
        }
        segments_.clear();
        if (!bar_nodes_.empty()) {
            for (const renderer::Bar& bar : draw_list(scene, view_).bars) segments_.push_back(segment_of(bar));
        }
        tracks_.add(poses_, segments_, marks_.of(scene));
    }

    void finish() override {
        Values seconds;
        for (std::size_t n = 0; n < tracks_.frames(); ++n) {
            seconds.push_back(static_cast<float>(static_cast<double>(n) / fps_));
        }
        const int times = document_.add_times(seconds);
        for (std::size_t i = 0; i < movers_.size(); ++i) add_pose(movers_[i].node, times, i);
        if (camera_.degrees_a_second != 0.0) add_pose(camera_node_, times, movers_.size());
        for (std::size_t i = 0; i < bar_nodes_.size(); ++i) add_bar(times, i);
        marks_.add_to(document_, tracks_, seconds, times);
        document_.write(file_);
        file_.commit();
    }

    std::string file_name() const override { return file_.name(); }

  private:
    struct Mover {
        std::size_t body;
        int node;
    };

    void add_pose(int node, int times, std::size_t i) {
        document_.add_channel(node, Path::translation, times, false, [this, i] { return tracks_.positions(i); });
        document_.add_channel(node, Path::rotation, times, false, [this, i] { return tracks_.orientations(i); });
    }

    void add_bar(int times, std::size_t i) {
        const auto placed = [this, i] {
            std::vector<std::optional<Segment>> keys;
            for (std::size_t n = 0; n < tracks_.frames(); ++n) keys.push_back(tracks_.segment(n, i));
            return stretched(keys, bar_stretches_[i]);
        };
        add_stretched(document_, bar_nodes_[i], times, false, placed);
    }

    OutputFile file_;
    long every_;  // steps per frame
    double fps_;
    CameraChoice camera_;
    View view_;
    Marks marks_;
    Document document_;
    std::vector<Mover> movers_;
    std::vector<int> bar_nodes_;
    std::vector<Stretch> bar_stretches_;
    int camera_node_ = -1;
    Tracks tracks_;
    std::vector<Pose> poses_;        // of a frame
    std::vector<Segment> segments_;  // of a frame
};

}  // namespace

void check_glb(const std::filesystem::path& file, const Choices& choices) {
    const auto refuse = [&](const std::string& why) {
        throw UsageError(fmt::format("--glb {}: {}", file.string(), why));
    };
    const FrameChoices& frames = choices.frames;
    if (!file.filename().string().ends_with(".glb")) refuse("must end in .glb");
    if (!frames.at.empty()) refuse("must be of a sequence, not of stills (--at)");
    if (frames.compare) refuse("must be for one run, not with --compare");
    for (const OverlayItem& item : frames.overlay) {
        if (colours_bodies(item.kind)) {
            refuse(fmt::format("must be without --overlay {}, because a body has one colour in all frames",
                               name_of(item.kind)));
        }
    }
    const long count = whole_steps(choices.settings) / steps_a_key(choices) + 1;
    const auto bodies = std::ranges::count_if(choices.description.bodies, can_move);
    const double gigabytes = 28e-9 * static_cast<double>(count) * static_cast<double>(bodies);
    if (count > most_frames) refuse(fmt::format("must have at most {} frames, not {}", most_frames, count));
    if (gigabytes > 4.29) {
        refuse(fmt::format("must be at most 4.29 GB, not the {:.2f} GB of {} bodies in {} frames", gigabytes,
                           bodies, count));
    }
}

std::unique_ptr<Record> glb_record(const std::filesystem::path& file, const std::vector<ComparedRun>& run,
                                   SurveyOnce& survey, const Simulation& start) {
    const Choices& choices = run.front().choices;
    check_glb(file, choices);
    require_drawable(start.scene());
    require_shown(start.scene(), choices.frames.overlay);
    const Survey found = needs_survey(choices.frames) ? survey.of(run) : Survey{};
    return std::make_unique<GlbRecord>(file, choices, found, start);
}

}  // namespace pushfactor::demos::pictures
