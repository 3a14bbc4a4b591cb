#include "demos/pictures/camera/overview.h"

#include "demos/pictures/camera/balls.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace pushfactor::demos::pictures {

namespace {

using engine::Vector3;

// The view turned about the vertical so that it looks across the motion, if that goes mostly one way: along it
// bodies would hide each other. The side and a part of the direction stay.
View across(const View& view, const std::vector<Ball>& places) {
    constexpr double one_way = 0.3;  // share of the shorter spread in the longer one
    constexpr double slant = 0.35;   // rad from straight across, for depth
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    const auto on_ground = [](const Vector3& point) { return Eigen::Vector2d(point.x(), point.z()); };
    for (const Ball& ball : places) mean += on_ground(ball.centre) / static_cast<double>(places.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Ball& ball : places) {
        const Eigen::Vector2d away = on_ground(ball.centre) - mean;
        spread += away * away.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
    const Vector3 out = view.eye - view.target;
    if (std::sqrt(axes.eigenvalues()[0]) >= one_way * std::sqrt(axes.eigenvalues()[1])) return view;
    Eigen::Vector2d aside = axes.eigenvectors().col(0);
    if (aside.dot(on_ground(out)) < 0.0) aside = -aside;
    const auto angle_of = [](const Eigen::Vector2d& v) { return std::atan2(v.x(), v.y()); };
    const double turn = std::remainder(angle_of(aside) - angle_of(on_ground(out)), 2.0 * std::numbers::pi);
    if (std::abs(turn) <= slant) return view;
    View turned = view;
    turned.eye = view.target + Eigen::AngleAxisd(turn - std::copysign(slant, turn), Vector3::UnitY()) * out;
    return turned;
}

}  // namespace

View overview(const View& view, const std::vector<Ball>& start, std::vector<Ball> reached, double aspect) {
    if (start.empty()) return view;
    const Eigen::AlignedBox3d near = surroundings(start);
    for (Ball& ball : reached) ball.centre = ball.centre.cwiseMax(near.min()).cwiseMin(near.max());
    reached.insert(reached.end(), start.begin(), start.end());
    return fitted(across(view, reached), reached, aspect);
}

}  // namespace pushfactor::demos::pictures
