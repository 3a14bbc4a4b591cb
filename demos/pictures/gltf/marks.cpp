#include "demos/pictures/gltf/marks.h"

#include "demos/pictures/gltf/stage.h"
#include "demos/pictures/overlays/overlay.h"

#include <algorithm>

namespace pushfactor::demos::pictures::gltf {

namespace {

using engine::Vector3;

// Radius of lines and points as a share of the distance from eye to target.
constexpr double relative_width = 0.003;

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

}  // namespace

Marks::Marks(const std::vector<OverlayItem>& overlay, const Survey& survey, const View& view)
    : scales_(scales_of(overlay, survey, view)), width_(relative_width * (view.target - view.eye).norm()) {
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

std::size_t Marks::kind_of(OverlayKind overlay, Form form, const glm::vec3& colour) const {
    const auto found = std::ranges::find_if(kinds_, [&](const Kind& kind) {
        return kind.overlay == overlay && kind.form == form && kind.colour == colour;
    });
    return static_cast<std::size_t>(found - kinds_.begin());
}

std::vector<Mark> Marks::of(const BuiltScene& scene) const {
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

Stretch Marks::stretch_of(Form form) const {
    if (form == Form::arrow) return {.origin = Stretch::Origin::start, .per_length = Vector3::Ones()};
    const Vector3 along = form == Form::line ? Vector3(0.0, 0.5, 0.0) : Vector3(Vector3::Zero());
    const double radius = form == Form::line ? width_ : 2.0 * width_;
    return {.origin = Stretch::Origin::middle, .per_length = along, .fixed = Vector3::Constant(radius)};
}

void Marks::add_to(Document& document, const Tracks& tracks, const Values& seconds, int times) const {
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

void add_stretched(Document& document, int node, int times, bool step, const std::function<Stretched()>& placed) {
    document.add_channel(node, Path::translation, times, step, [placed] { return placed().translations; });
    document.add_channel(node, Path::rotation, times, step, [placed] { return placed().rotations; });
    document.add_channel(node, Path::scale, times, step, [placed] { return placed().scales; });
}

}  // namespace pushfactor::demos::pictures::gltf
