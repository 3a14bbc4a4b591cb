#include "demos/pictures/camera/composition.h"

#include "demos/pictures/camera/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace pushfactor::demos::pictures {

namespace {

using engine::Vector3;

constexpr double degrees = std::numbers::pi / 180.0;
constexpr double highest = 60.0;  // degrees above the horizon that the camera is raised to
constexpr double margin = 0.05;   // share of the picture at each side that stays free
constexpr double most = 0.12;     // share of the picture's width that the subject is moved aside

// The view from another side of its target: turned to the right and raised, in degrees.
View moved_around(const View& view, double turn, double raise) {
    const Vector3 from = view.eye - view.target;
    const double level = std::hypot(from.x(), from.z());
    const double elevation = std::atan2(from.y(), level);
    const double azimuth = std::atan2(from.x(), from.z()) + turn * degrees;
    const double raised = std::max(elevation, std::min(elevation + raise * degrees, highest * degrees));
    View moved = view;
    moved.eye = view.target + from.norm() * Vector3(std::cos(raised) * std::sin(azimuth), std::sin(raised),
                                                    std::cos(raised) * std::cos(azimuth));
    return moved;
}

// Moves the camera sideways, so that subject and shadow together are in the middle, as far as the subject stays in
// the picture.
View balanced(const View& view, const Subject& subject, double aspect) {
    const Extent own = extent_of(subject.points, view, aspect);
    const Extent thrown = extent_of(subject.shadow, view, aspect);
    const double left = std::min(own.left, std::max(thrown.left, own.left - own.height()));
    const double right = std::max(own.right, std::min(thrown.right, own.right + own.height()));
    // Positive to the right: the subject then goes to the left.
    const double wanted = 0.5 * (left + right) - 0.5;
    const double most_right = std::clamp(0.45 * (own.left - margin), 0.0, most);
    const double most_left = std::clamp(0.45 * (own.right - 1.0 + margin), -most, 0.0);
    const double shift = std::clamp(wanted, most_left, most_right);
    const Vector3 forward = view.target - view.eye;
    const Vector3 right_hand = forward.cross(Vector3::UnitY());
    if (right_hand.norm() < 1e-3 * forward.norm()) return view;
    const Vector3 offset = 2.0 * shift * half_tangent(view) * aspect * forward.norm() * right_hand.normalized();
    View moved = view;
    moved.eye += offset;
    moved.target += offset;
    return moved;
}

}  // namespace

Extent extent_of(std::span<const Vector3> points, const View& view, double aspect) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Extent extent{.left = infinity, .top = infinity, .right = -infinity, .bottom = -infinity};
    for (const Vector3& point : points) {
        const Place place = place_in_picture(point, view, aspect);
        extent.left = std::min(extent.left, place.x);
        extent.right = std::max(extent.right, place.x);
        extent.top = std::min(extent.top, place.y);
        extent.bottom = std::max(extent.bottom, place.y);
    }
    return extent;
}

View composed(const View& view, const Subject& subject, double aspect) {
    if (subject.points.empty()) return view;
    std::vector<Ball> points;
    for (const Vector3& point : subject.points) points.push_back({.centre = point});
    View best = view;
    double highest_worth = -1.0;
    for (const double raise : {0.0, 10.0, 20.0}) {
        for (const double turn : {0.0, -15.0, 15.0, -30.0, 30.0, -45.0, 45.0}) {
            const View fit = fitted(moved_around(view, turn, raise), points, aspect);
            const Extent extent = extent_of(subject.points, fit, aspect);
            // Another side than the scene's has to be worth it.
            const double worth =
                std::sqrt(extent.width() * extent.height()) * (1.0 - 0.005 * std::abs(turn) - 0.006 * raise);
            if (worth <= highest_worth + 1e-9) continue;
            highest_worth = worth;
            best = fit;
        }
    }
    return subject.shadow.empty() ? best : balanced(best, subject, aspect);
}

}  // namespace pushfactor::demos::pictures
