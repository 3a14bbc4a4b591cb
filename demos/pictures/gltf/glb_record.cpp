#include "demos/pictures/gltf/glb_record.h"

#include "demos/base/platform/output_file.h"
#include "demos/base/text/errors.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/gltf/stage.h"
#include "demos/pictures/lettering.h"
#include "demos/pictures/overlays/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

namespace pushfactor::demos::pictures {

namespace {

using namespace gltf;
using engine::Vector3;

// The nth mark of a kind in the frames in which it changes.
struct Keys {
    std::vector<std::uint32_t> frames;
    std::vector<std::optional<Segment>> segments;
};

Keys keys_of(const Tracks& tracks, std::size_t kind, std::size_t nth) {
    Keys keys;
    for (std::size_t frame = 0; frame < tracks.frames(); ++frame) {
        const std::optional<Segment> mark = tracks.mark(frame, kind, nth);
        if (frame > 0 && mark == keys.segments.back()) continue;
        keys.frames.push_back(static_cast<std::uint32_t>(frame));
        keys.segments.push_back(mark);
    }
    return keys;
}

// Adds the channels of those properties that change; `placed` is called for each of them again.
void add_stretched(Document& document, int node, int times, bool step, const std::function<Stretched()>& placed) {
    document.add_channel(node, Path::translation, times, step, [placed] { return placed().translations; });
    document.add_channel(node, Path::rotation, times, step, [placed] { return placed().rotations; });
    document.add_channel(node, Path::scale, times, step, [placed] { return placed().scales; });
}

// Arrows, lines and points of overlays. They appear and vanish, so that the nth of a kind is one node in all
// frames, with scale 0 in those that have fewer.
class Marks {
  public:
    // Widths depend on `view`.
    Marks(const std::vector<OverlayItem>& overlay, const Survey& survey, const View& view)
        : scales_(scales_of(overlay, survey, view)), width_(0.003 * distance_of(view)) {
        for (const Scale& scale : scales_) {
            for (const LegendEntry& entry : entries_of(scale.kind)) {
                const std::string name = entry.name.substr(0, entry.name.find(','));
                const glm::vec3 colour = to_glm(entry.colour);
                if (has_arrows(scale.kind)) {
                    kinds_.push_back({scale.kind, Form::arrow, name, colour});
                    continue;
                }
                kinds_.push_back({scale.kind, Form::point, name, colour});
                kinds_.push_back({scale.kind, Form::line, name, colour});
            }
        }
    }

    // Those of the scene's last step; arrows without length are left out.
    std::vector<Mark> of(const BuiltScene& scene) const {
        std::vector<Mark> marks;
        for (const Scale& scale : scales_) {
            renderer::Picture picture;
            add_overlay(scene, scale.kind, scale.units_a_metre, picture);
            for (const renderer::Arrow& arrow : picture.arrows) {
                if (arrow.from == arrow.to) continue;
                const std::size_t kind = kind_of(scale.kind, arrow.head ? Form::arrow : Form::line, arrow.colour);
                marks.push_back({kind, {to_eigen(arrow.from), to_eigen(arrow.to)}});
            }
            for (const renderer::Dot& dot : picture.dots) {
                const Vector3 place = to_eigen(dot.position);
                marks.push_back({kind_of(scale.kind, Form::point, dot.colour), {place, place}});
            }
        }
        return marks;
    }

    // Adds the nodes and their channels. `tracks` must outlive the document; `seconds` are the times of its frames
    // and `times` their accessor. A node has keys only in frames in which it changes.
    void add_to(Document& document, const Tracks& tracks, const Values& seconds, int times) const {
        for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
            const std::size_t count = tracks.most_marks(kind);
            if (count == 0) continue;
            const auto& [overlay, form, name, colour] = kinds_[kind];
            const Paint paint{.colour = colour};
            const bool round = form == Form::point;
            const int geometry = document.add_geometry(round ? ball() : form == Form::line ? rod() : arrow());
            const int mesh = document.mesh(geometry, name, round ? std::vector{paint, paint} : std::vector{paint});
            const int parent = document.add_node({{"name", name}});
            const Stretch how = stretch_of(form);
            for (std::size_t nth = 0; nth < count; ++nth) {
                const Keys keys = keys_of(tracks, kind, nth);
                const auto placed = [&tracks, kind, nth, how] {
                    return stretched(keys_of(tracks, kind, nth).segments, how);
                };
                const int node =
                    document.add_node(node_at(name + " " + std::to_string(nth + 1), mesh, placed()), parent);
                if (keys.frames.size() == 1) continue;
                int own_times = times;
                if (keys.frames.size() < tracks.frames()) {
                    Values some;
                    for (const std::uint32_t frame : keys.frames) some.push_back(seconds[frame]);
                    own_times = document.add_times(some);
                }
                add_stretched(document, node, own_times, true, placed);
            }
        }
    }

  private:
    enum class Form { arrow, line, point };
    struct Kind {
        OverlayKind overlay;
        Form form;
        std::string name;
        glm::vec3 colour;
    };

    std::size_t kind_of(OverlayKind overlay, Form form, const glm::vec3& colour) const {
        const auto found = std::ranges::find_if(kinds_, [&](const Kind& kind) {
            return kind.overlay == overlay && kind.form == form && kind.colour == colour;
        });
        return static_cast<std::size_t>(found - kinds_.begin());
    }

    Stretch stretch_of(Form form) const {
        if (form == Form::arrow) return {.origin = Stretch::Origin::start, .per_length = Vector3::Ones()};
        const Vector3 along = form == Form::line ? Vector3(0.0, 0.5, 0.0) : Vector3(Vector3::Zero());
        const double radius = form == Form::line ? width_ : 2.0 * width_;
        return {.origin = Stretch::Origin::middle, .per_length = along, .fixed = Vector3::Constant(radius)};
    }

    std::vector<Scale> scales_;
    std::vector<Kind> kinds_;
    double width_;  // m, radius of lines
};

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
    return choices.frames.camera.fit ? composed(view, survey.subject, choices.frames.aspect()) : view;
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
        camera_node_ = add_camera(turned(camera_, view_, start.sample().time), choices.frames.aspect(), document_);
        add_sun(picture, document_);
        observe(start);
    }

    void observe(const Simulation& simulation) override {
        if (simulation.sample().step % every_ != 0) return;
        const BuiltScene& scene = simulation.scene();
        std::vector<Pose> poses;
        for (const Mover& mover : movers_) {
            const engine::Body& body = scene.world.bodies[mover.body];
            poses.push_back({body.position, body.orientation});
        }
        if (camera_.degrees_a_second != 0.0) {
            poses.push_back(pose_of(turned(camera_, view_, simulation.sample().time)));
        }
        std::vector<Segment> segments;
        if (!bar_nodes_.empty()) {
            for (const renderer::Bar& bar : draw_list(scene, view_).bars) segments.push_back(segment_of(bar));
        }
        tracks_.add(poses, segments, marks_.of(scene));
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
};

}  // namespace

void check_glb(const std::filesystem::path& file, const Choices& choices) {
    const auto refuse = [&](const std::string& why) { throw UsageError("--glb {}: {}", file.string(), why); };
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
