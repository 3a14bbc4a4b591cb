#include "demos/pictures/film/film.h"

#include "demos/base/platform/channel.h"
#include "demos/base/platform/progress.h"
#include "demos/base/text/errors.h"
#include "demos/pictures/draw_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

Film::Film(OffscreenRenderer& offscreen, const Session& session, SurveyOnce& survey)
    : offscreen_(offscreen),
      session_(session),
      choices_(session.choices(0).frames),
      caption_(caption_of(session.choices(0))) {
    const std::vector<ComparedRun>& panels = session.sequence().panels;
    constexpr double widest = 16.0 / 9.0;  // aspect ratio for which the scenes' views are made
    double across = 0.0, up = 0.0;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        require_drawable(scene(i));
        require_shown(scene(i), choices_.overlay);
        const View view = seen_from(scene(i));
        const double reach = reach_across(movable_balls(scene(i)), view);
        across = std::max(across, std::clamp(reach, 0.1, widest * half_tangent(view)));
        up = std::max(up, half_tangent(view));
    }
    if (needs_survey(choices_)) survey_ = survey.of(panels);
    const float size = letter_size(choices_.height);
    if (panels.size() > 1 && (choices_.caption || legend_lines() > 0)) {
        strip_ = static_cast<int>(std::ceil(legend_height(std::max<std::size_t>(legend_lines(), 1), size)));
        if (strip_ > choices_.height / 2) strip_ = 0;  // a thumbnail
    }
    const Size sheet{choices_.width, choices_.height - strip_};
    layout_ = choices_.camera.fit ? closest_layout(sheet)
                                  : best_layout(sheet, static_cast<int>(panels.size()), across, up);
    layout_.sheet.height = choices_.height;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        views_.push_back(place_camera(scene(i), panels.size() > 1 ? across : 0.0));
    }
    scales_ = scales_of(choices_.overlay, survey_, views_.front());
    for (std::size_t i = 0; i < panels.size(); ++i) {
        motions_.emplace_back(choices_, session.run(i));
        note(i);
    }
}

// That whose cells show the subject largest.
Layout Film::closest_layout(const Size& sheet) const {
    return best_layout(sheet, static_cast<int>(session_.size()), [&](const Layout& layout) {
        const View view = composed(seen_from(scene(0)), subject_in(layout.cell), layout.cell_aspect());
        return layout.cell.height / (half_tangent(view) * distance_of(view));
    });
}

// With room for what is written into a cell.
Subject Film::subject_in(const Size& cell) const {
    const double line = 1.9 * letter_size(choices_.height) / cell.height;
    const double lines_below =
        strip_ > 0 ? 0.0 : (choices_.caption ? 1.0 : 0.0) + static_cast<double>(legend_lines());
    const bool has_label = !session_.sequence().panels.front().label.empty();
    return with_room(survey_.subject, has_label ? line : 0.0, lines_below * line);
}

View Film::seen_from(const BuiltScene& scene) const {
    return choices_.camera.view.value_or(scene.view);
}

View Film::place_camera(const BuiltScene& scene, double across) const {
    const View view = seen_from(scene);
    const double aspect = layout_.cell_aspect();
    return choices_.camera.fit ? composed(view, subject_in(layout_.cell), aspect) : widened(view, across, aspect);
}

void Film::note(std::size_t panel) {
    if (motions_[panel].wants_steps()) motions_[panel].note(coloured(panel));
}

// Without marks.
renderer::Picture Film::coloured(std::size_t panel) const {
    const Simulation& run = session_.run(panel);
    renderer::Picture picture = draw_list(run.scene(), turned(choices_.camera, views_[panel], run.sample().time));
    for (const Scale& scale : scales_) {
        if (colours_bodies(scale.kind)) add_overlay(run.scene(), scale.kind, scale.units_a_metre, picture);
    }
    return picture;
}

renderer::Picture Film::look(std::size_t panel) const {
    renderer::Picture picture = coloured(panel);
    for (const Scale& scale : scales_) {
        if (colours_bodies(scale.kind)) continue;
        add_overlay(scene(panel), scale.kind, scale.units_a_metre, picture);
    }
    motions_[panel].add_trails(picture);
    motions_[panel].add_ghosts(picture);
    return picture;
}

Snapshot Film::look(const std::string& name) const {
    Snapshot moment{.name = name, .time = session_.run(0).sample().time, .pictures = {}, .open = {}};
    for (std::size_t i = 0; i < session_.size(); ++i) {
        moment.pictures.push_back(look(i));
        moment.open.push_back(motions_[i].while_open());
        for (Moment& open : moment.open.back()) motions_[i].add_ghosts(open.picture);
    }
    return moment;
}

std::vector<LegendLine> Film::legend(const View& view) const {
    std::vector<LegendLine> lines;
    for (const Scale& scale : scales_) {
        const std::vector<LegendEntry> entries = entries_of(scale.kind);
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (!survey_.shown.contains({scale.kind, i})) continue;
            lines.push_back(legend_line(entries[i], scale, view, layout_.cell.height));
        }
    }
    if (!choices_.ghosts.empty()) {
        std::string times;
        for (const Rational& time : choices_.ghosts) times += (times.empty() ? "" : ", ") + to_text(time);
        lines.push_back({.colour = *find_colour(colour_of_none), .text = fmt::format("paler: at {} s", times)});
    }
    return lines;
}

std::size_t Film::legend_lines() const {
    return survey_.shown.size() + (choices_.ghosts.empty() ? 0 : 1);
}

void Film::write(renderer::Image& sheet, double time) const {
    const Lettering& lettering = offscreen_.lettering();
    const float size = letter_size(sheet.height);
    const auto width = static_cast<float>(sheet.width), height = static_cast<float>(sheet.height);
    const auto strip = static_cast<float>(strip_ > 0 ? strip_ : sheet.height);
    renderer::Rectangle below{0.0f, height - strip, width, strip};
    std::string caption = fmt::format("t = {:.2f} s   {}", time, caption_);
    if (session_.size() > 1) {
        std::vector<std::string> names;
        for (const ComparedRun& panel : session_.sequence().panels) names.push_back(panel.label);
        const float room = static_cast<float>(layout_.cell.width) - 2.0f * size;
        const auto widest = [&] {
            float most = 0.0f;
            for (const std::string& name : names) most = std::max(most, lettering.width(name, size));
            return most;
        };
        if (widest() > room) {  // names that are cut may be alike: values alone, in smaller letters where needed
            caption += "   compared: " + choices_.compare->option;
            for (std::string& name : names) name.erase(0, name.find(' ') + 1);
        }
        const float letters = size * std::clamp(room / widest(), 0.5f, 1.0f);
        for (std::size_t i = 0; i < names.size(); ++i) lettering.name(sheet, layout_.place(i), names[i], letters);
    }
    // Arrows in the legend have their length at the camera's target; if the cameras of the panels differ, each
    // panel has a legend.
    const bool alike = std::ranges::all_of(views_, [&](const View& view) {
        return distance_of(view) == distance_of(views_.front()) &&
               view.field_of_view == views_.front().field_of_view;
    });
    if (alike) {
        below.width -= lettering.legend(sheet, below, legend(views_.front()), size);
    } else {
        for (std::size_t i = 0; i < views_.size(); ++i) {
            lettering.legend(sheet, layout_.place(i), legend(views_[i]), size);
        }
    }
    if (choices_.caption) lettering.caption(sheet, below, caption, size);
}

void Film::draw_panel(const Snapshot& moment, std::size_t panel, renderer::Image& image) const {
    const renderer::Picture& picture = moment.pictures[panel];
    const std::vector<Moment>& open = moment.open[panel];
    if (open.size() < 2) {
        offscreen_.draw(std::span(&picture, 1), layout_.cell, choices_.samples, image, panel);
        return;
    }
    const double end = open.back().time;
    std::vector<renderer::Picture> spread_out = spread(open, end - motions_[panel].open(), end, choices_.samples);
    spread_out.back().arrows = picture.arrows;
    spread_out.back().dots = picture.dots;
    spread_out.back().mark_scale = picture.mark_scale;
    offscreen_.draw(spread_out, layout_.cell, choices_.samples, image, panel);
}

void Film::draw(const Snapshot& moment, renderer::Image& sheet) const {
    if (moment.pictures.size() == 1) {
        draw_panel(moment, 0, sheet);
    } else {
        std::vector<renderer::Image> images(moment.pictures.size());
        for (std::size_t i = 0; i < images.size(); ++i) draw_panel(moment, i, images[i]);
        sheet = assemble(layout_, images);
    }
    write(sheet, moment.time);
    offscreen_.end("captions");
}

void require_poses_only(const Sequence& sequence, const std::string& file) {
    const FrameChoices& frames = sequence.panels.front().choices.frames;
    if (sequence.panels.size() > 1) {
        throw UsageError("--from-trajectory {}: must be of one run, not with --compare", file);
    }
    for (const auto& [option, given] :
         {std::pair{"--ghosts", !frames.ghosts.empty()}, std::pair{"--shutter", frames.shutter > 0.0}}) {
        if (!given) continue;
        throw UsageError("{}: must not be with --from-trajectory, which takes no steps between frames", option);
    }
    for (const OverlayItem& item : frames.overlay) {
        if (item.kind == OverlayKind::no_contacts) continue;
        throw UsageError(
            "--overlay {}: must not be with --from-trajectory, which has poses only; without it each "
            "shard simulates the run itself",
            name_of(item.kind));
    }
}

void take_frames(Session& session, Observer* recorder, const Pictures& pictures, FrameQueue& queue,
                 StageTimes* times, const std::function<void(long)>& progress) {
    constexpr std::size_t ahead = 2;
    Producer<Snapshot> moments(ahead, [&](Channel<Snapshot>& channel) {
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
