#include "tests/peers/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pushfactor::tests::peers {

namespace {

using Matrix3 = Eigen::Matrix3d;

constexpr double rounding = 1e-9;  // m: bodies that are built to touch overlap by some 1e-15

struct Placed {
    const Body* body = nullptr;
    bool movable = true;
    Vector3 centre;
    Matrix3 axes;   // of a box, as columns
    Vector3 half;   // edges of a box
    Vector3 reach;  // half edges of the bounding box, world frame
};

Placed placed(const Body& body, const State& s, bool movable) {
    Placed result{&body, movable, s.position, s.orientation.toRotationMatrix(), 0.5 * body.size, {}};
    result.reach = body.shape == Shape::box ? Vector3(result.axes.cwiseAbs() * result.half)
                                            : Vector3(Vector3::Constant(body.radius));
    return result;
}

double depth_in_plane(const Placed& p, const Body& plane) {
    const Vector3 normal = plane.start.orientation * Vector3::UnitY();
    const double reach =
        p.body->shape == Shape::box ? (p.axes.transpose() * normal).cwiseAbs().dot(p.half) : p.body->radius;
    return reach - normal.dot(p.centre - plane.start.position);
}

double depth_of_balls(const Placed& a, const Placed& b) {
    return a.body->radius + b.body->radius - (b.centre - a.centre).norm();
}

double depth_of_ball_in_box(const Placed& ball, const Placed& box) {
    const Vector3 centre = box.axes.transpose() * (ball.centre - box.centre);
    const Vector3 inside = box.half - centre.cwiseAbs();  // distance from the faces
    if (inside.minCoeff() >= 0.0) return ball.body->radius + inside.minCoeff();
    return ball.body->radius - inside.cwiseMin(0.0).norm();
}

// Separating axes: three faces of each, nine pairs of edges.
double depth_of_boxes(const Placed& a, const Placed& b) {
    const Vector3 between = a.axes.transpose() * (b.centre - a.centre);  // frame of a
    const Matrix3 turn = a.axes.transpose() * b.axes;                    // axes of b in the frame of a
    const Matrix3 sizes = turn.cwiseAbs();
    const Vector3 faces_a = a.half + sizes * b.half - between.cwiseAbs();
    if (faces_a.minCoeff() <= 0.0) return 0.0;
    const Vector3 faces_b = b.half + sizes.transpose() * a.half - (turn.transpose() * between).cwiseAbs();
    double depth = std::min(faces_a.minCoeff(), faces_b.minCoeff());
    for (int i = 0; i < 3 && depth > 0.0; ++i) {
        for (int k = 0; k < 3; ++k) {
            const Vector3 axis = Vector3::Unit(i).cross(turn.col(k));
            const double length = axis.norm();
            if (length < 1e-6) continue;  // parallel edges: a face is as good
            const double reach = axis.cwiseAbs().dot(a.half) + (turn.transpose() * axis).cwiseAbs().dot(b.half);
            depth = std::min(depth, (reach - std::abs(axis.dot(between))) / length);
        }
    }
    return depth;
}

double depth_of(const Placed& a, const Placed& b) {
    const bool box_a = a.body->shape == Shape::box, box_b = b.body->shape == Shape::box;
    if (box_a && box_b) return depth_of_boxes(a, b);
    if (box_a) return depth_of_ball_in_box(b, a);
    if (box_b) return depth_of_ball_in_box(a, b);
    return depth_of_balls(a, b);
}

class Sum {
  public:
    void add(double depth) {
        if (!(depth > rounding)) return;
        deepest_ = std::max(deepest_, depth);
        squares_ += depth * depth;
        ++pairs_;
    }

    Overlap result() const {
        return {deepest_, pairs_ > 0 ? std::sqrt(squares_ / static_cast<double>(pairs_)) : 0.0, pairs_};
    }

  private:
    double deepest_ = 0.0, squares_ = 0.0;
    std::size_t pairs_ = 0;
};

}  // namespace

Overlap overlap(const Scene& scene, const std::vector<State>& states) {
    Sum sum;
    std::vector<Placed> all;
    for (std::size_t i = 0; i < states.size(); ++i) all.push_back(placed(scene.movable[i], states[i], true));
    for (const Body& body : scene.fixed) {
        if (body.shape != Shape::plane) {
            all.push_back(placed(body, body.start, false));
            continue;
        }
        for (std::size_t i = 0; i < states.size(); ++i) sum.add(depth_in_plane(all[i], body));
    }
    // Pairs by sweep and prune along x.
    const auto low = [](const Placed& p) { return p.centre.x() - p.reach.x(); };
    std::sort(all.begin(), all.end(), [&](const Placed& a, const Placed& b) { return low(a) < low(b); });
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Placed& a = all[i];
        for (std::size_t k = i + 1; k < all.size() && low(all[k]) < a.centre.x() + a.reach.x(); ++k) {
            const Placed& b = all[k];
            const Vector3 apart = (b.centre - a.centre).cwiseAbs() - a.reach - b.reach;
            if (apart.maxCoeff() < 0.0 && (a.movable || b.movable)) sum.add(depth_of(a, b));
        }
    }
    return sum.result();
}

}  // namespace pushfactor::tests::peers
