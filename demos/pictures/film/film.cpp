#include "demos/pictures/film/film.h"

#include "demos/pictures/caption.h"
#include "demos/pictures/draw_list.h"
#include "demos/pictures/overlays/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pushfactor::demos::pictures {

namespace {

constexpr double widest = 16.0 / 9.0;  // aspect ratio for which the scenes' views are made

double distance_of(const View& view) {
    return (view.target - view.eye).norm();
}

// 1, 2 or 5 times a power of ten, at most `value`.
double round_number(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double digit = value / power;
    return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

}  // namespace

Film::Film(Studio& studio, const std::vector<ComparedRun>& panels, std::vector<const Simulation*> runs,
           const std::vector<std::vector<Frame>>& frames, const GoTo& go_to)
    : studio_(studio),
      choices_(panels.front().choices.frames),
      runs_(std::move(runs)),
      caption_(caption_of(panels.front().choices)) {
    for (const Simulation* run : runs_) require_shown(run->scene(), choices_.overlay);
    if (needs_survey(choices_)) survey_ = pictures::survey(panels, frames, go_to);

    double across = 0.0, up = 0.0;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        labels_.push_back(panels[i].label);
        const BuiltScene& scene = runs_[i]->scene();
        const View view = choices_.camera.view.value_or(scene.view);
        const Reach reach = reach_of(movable_balls(scene), view);
        across = std::max(across, std::clamp(reach.across, 0.1, widest * half_tangent(view)));
        up = std::max(up, half_tangent(view));
    }
    layout_ = best_layout({choices_.width, choices_.height}, static_cast<int>(panels.size()), across, up);
    for (const Simulation* run : runs_) {
        views_.push_back(place_camera(run->scene(), panels.size() > 1 ? across : 0.0));
    }
    scales_ = scales_of(choices_.overlay, survey_, views_.front());
}

View Film::place_camera(const BuiltScene& scene, double across) const {
    const View view = choices_.camera.view.value_or(scene.view);
    const double aspect = static_cast<double>(layout_.cell.width) / layout_.cell.height;
    return choices_.camera.fit ? fitted(view, survey_.reached, aspect) : widened(view, across, aspect);
}

renderer::Picture Film::look(std::size_t panel) const {
    const Simulation& run = *runs_[panel];
    renderer::Picture picture = draw_list(run.scene(), turned(choices_.camera, views_[panel], run.sample().time));
    for (const Scale& scale : scales_) add_overlay(run.scene(), scale.kind, scale.units_a_metre, picture);
    return picture;
}

Snapshot Film::look(const std::string& name) const {
    Snapshot moment{.name = name, .time = runs_.front()->sample().time, .pictures = {}};
    for (std::size_t i = 0; i < runs_.size(); ++i) moment.pictures.push_back(look(i));
    return moment;
}

std::vector<LegendLine> Film::legend(const View& view) const {
    std::vector<LegendLine> lines;
    const double distance = distance_of(view);
    const double pixels_a_metre = 0.5 * layout_.cell.height / (distance * half_tangent(view));
    for (const Scale& scale : scales_) {
        const std::vector<LegendEntry> entries = entries_of(scale.kind);
        const double example = round_number(1.3 * typical_arrow * distance * scale.units_a_metre);
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (!survey_.shown.contains({scale.kind, i})) continue;
            const bool points = entries[i].unit.empty();
            lines.push_back(
                {.colour = entries[i].colour,
                 .text = points ? entries[i].name
                                : fmt::format("{}, {:g} {}", entries[i].name, example, entries[i].unit),
                 .arrow = points ? 0.0f : static_cast<float>(example / scale.units_a_metre * pixels_a_metre)});
        }
    }
    return lines;
}

void Film::write(renderer::Image& sheet, double time) const {
    const Lettering& lettering = studio_.lettering();
    const float size = letter_size(sheet.height);
    const renderer::Rectangle all{0.0f, 0.0f, static_cast<float>(sheet.width), static_cast<float>(sheet.height)};
    for (std::size_t i = 0; i < labels_.size(); ++i) {
        if (!labels_[i].empty()) lettering.name(sheet, layout_.place(i), labels_[i], size);
    }
    if (choices_.caption) {
        lettering.caption(sheet, all, fmt::format("t = {:.2f} s   {}", time, caption_), size);
    }
    if (scales_.empty()) return;
    // Arrows in the legend have their length at the camera's target; if the cameras of the panels differ, each
    // panel has a legend.
    const bool alike = std::all_of(views_.begin(), views_.end(), [&](const View& view) {
        return distance_of(view) == distance_of(views_.front()) &&
               view.field_of_view == views_.front().field_of_view;
    });
    for (std::size_t i = alike ? views_.size() - 1 : 0; i < views_.size(); ++i) {
        lettering.legend(sheet, layout_.place(i), legend(views_[i]), size);
    }
}

void Film::draw(const Snapshot& moment, renderer::Image& sheet) const {
    if (moment.pictures.size() == 1) {
        studio_.draw(moment.pictures.front(), layout_.cell, choices_.samples, sheet);
    } else {
        std::vector<renderer::Image> images(moment.pictures.size());
        for (std::size_t i = 0; i < images.size(); ++i) {
            studio_.draw(moment.pictures[i], layout_.cell, choices_.samples, images[i], i);
        }
        sheet = assemble(layout_, images);
    }
    write(sheet, moment.time);
    studio_.end("captions");
}

}  // namespace pushfactor::demos::pictures
