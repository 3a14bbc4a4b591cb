#include "demos/pictures/film/motion.h"

#include "demos/pictures/draw_list.h"
#include "demos/pictures/to_glm.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::demos::pictures {

namespace {

using engine::Vector3;
using renderer::Picture;

constexpr glm::vec3 pale(0.84f, 0.855f, 0.875f);  // about that of the ground and the sky
constexpr double slack = 1e-9;                    // s, for rounded times
// Share of the distance from eye to target by which a ghost is behind the next younger one, and that behind the
// body: where they are nearly at one place, the younger one is to be seen. The layers of body.vert, which are
// against bodies that share a face, move a later body forwards by up to 3e-3 of it.
constexpr float behind = 4e-3f;

void move(renderer::Bar& bar, const renderer::Bar& from, float share) {
    bar.from = glm::mix(from.from, bar.from, share);
    bar.to = glm::mix(from.to, bar.to, share);
}

void move(renderer::Body& body, const renderer::Body& from, float share) {
    body.position = glm::mix(from.position, body.position, share);
    body.orientation = glm::slerp(from.orientation, body.orientation, share);
}

template <typename Thing>
void move_all(std::vector<Thing>& things, const std::vector<Thing>& from, float share) {
    if (things.size() != from.size()) return;
    for (std::size_t i = 0; i < things.size(); ++i) move(things[i], from[i], share);
}

Picture between(const Picture& before, const Picture& after, float share) {
    Picture picture = after;
    picture.camera.eye = glm::mix(before.camera.eye, after.camera.eye, share);
    picture.camera.target = glm::mix(before.camera.target, after.camera.target, share);
    move_all(picture.bodies, before.bodies, share);
    move_all(picture.bars, before.bars, share);
    return picture;
}

bool same_place(const renderer::Bar& a, const renderer::Bar& b) {
    return a.from == b.from && a.to == b.to;
}

bool same_place(const renderer::Body& a, const renderer::Body& b) {
    return a.position == b.position && a.orientation == b.orientation;
}

void shift(renderer::Bar& bar, const glm::vec3& by) {
    bar.from += by;
    bar.to += by;
}

void shift(renderer::Body& body, const glm::vec3& by) {
    body.position += by;
}

// How a ghost differs from the body where it was.
struct Ghost {
    float paleness;
    glm::vec3 back;  // m
};

// `own` is the number of bodies that are no ghosts.
template <typename Thing>
void add_moved(const std::vector<Thing>& then, std::size_t own, const Ghost& ghost, std::vector<Thing>& now) {
    for (std::size_t i = 0; i < std::min(then.size(), own); ++i) {
        if (same_place(then[i], now[i])) continue;
        now.push_back(then[i]);
        now.back().colour = glm::mix(then[i].colour, pale, ghost.paleness);
        shift(now.back(), ghost.back);
    }
}

}  // namespace

std::vector<Picture> spread(const std::vector<Moment>& moments, double from, double to, int count) {
    std::vector<Picture> pictures;
    for (int i = 0; i < count; ++i) {
        // The samples of a picture have an order of their own, which time must not follow.
        const double turn = 0.41421356237309515 * (i + 0.5);
        const double time = from + (turn - std::floor(turn)) * (to - from);
        const auto after = std::ranges::find_if(moments, [&](const Moment& m) { return m.time >= time; });
        if (after == moments.begin() || after == moments.end()) {
            pictures.push_back(after == moments.end() ? moments.back().picture : after->picture);
            continue;
        }
        const Moment& before = *std::prev(after);
        const double share = (time - before.time) / (after->time - before.time);
        pictures.push_back(between(before.picture, after->picture, static_cast<float>(share)));
    }
    return pictures;
}

Motion::Motion(const FrameChoices& choices, const Simulation& run)
    : run_(run),
      trail_(choices.trail_seconds()),
      open_(choices.shutter * choices.play_speed.value() / choices.film_rate().value()),
      ghost_steps_(plan_ghosts(choices, run.settings().dt)) {}

void Motion::note(const Picture& now) {
    const double time = run_.sample().time;
    if (std::ranges::binary_search(ghost_steps_, run_.sample().step)) ghosts_.push_back(now);
    if (open_ > 0.0) {
        moments_.push_back({time, now});
        while (moments_.size() > 2 && moments_[1].time <= time - open_ + slack) moments_.pop_front();
    }
    if (trail_ > 0.0) {
        Places places{.time = time, .centres = {}};
        for (std::size_t i = 0; i < run_.scene().bodies.size(); ++i) {
            places.centres.push_back(run_.scene().world.bodies[i].position);
        }
        path_.push_back(std::move(places));
        while (path_.front().time < time - trail_ - slack) path_.pop_front();
    }
}

void Motion::add_ghosts(Picture& now) const {
    const std::size_t bodies = now.bodies.size(), bars = now.bars.size();
    for (std::size_t i = 0; i < ghosts_.size(); ++i) {
        const auto younger = static_cast<float>(ghosts_.size() - i), all = static_cast<float>(ghosts_.size());
        const Ghost ghost{.paleness = 0.3f + 0.45f * younger / all,
                          .back = behind * younger * (now.camera.target - now.camera.eye)};
        add_moved(ghosts_[i].bodies, bodies, ghost, now.bodies);
        add_moved(ghosts_[i].bars, bars, ghost, now.bars);
    }
}

void Motion::add_trails(Picture& now) const {
    if (path_.size() < 2) return;
    // Long enough to be drawn, short enough for bends.
    const double piece = 0.005 * glm::distance(now.camera.eye, now.camera.target);
    const std::vector<glm::vec3> colours = colours_of(run_.scene());
    std::vector<renderer::Arrow> lines;
    for (std::size_t body = 0; body < colours.size(); ++body) {
        if (!goes_about(run_.scene().bodies[body])) continue;
        Vector3 end = path_.back().centres[body];
        for (auto places = path_.rbegin() + 1; places != path_.rend(); ++places) {
            const Vector3& place = places->centres[body];
            if ((place - end).norm() < piece) continue;
            const auto age = static_cast<float>((path_.back().time - places->time) / trail_);
            lines.push_back({.from = to_glm(place),
                             .to = to_glm(end),
                             .colour = glm::mix(colours[body], pale, std::min(0.1f + 0.9f * age, 1.0f)),
                             .head = false,
                             .outlined = false});
            end = place;
        }
    }
    // The newest on top, and arrows of other overlays on top of them.
    std::ranges::reverse(lines);
    now.arrows.insert(now.arrows.begin(), lines.begin(), lines.end());
}

}  // namespace pushfactor::demos::pictures
