#include "engine/bodies/solid.h"

#include "engine/base/wide.h"

#include <cmath>

// What Eigen has to know of numbers.
template <>
struct Eigen::NumTraits<pushfactor::engine::Wide> : Eigen::GenericNumTraits<pushfactor::engine::Wide> {
    enum { RequireInitialization = 1 };
};

namespace pushfactor::engine {

namespace {

// Wider than double, so that the moments of a cube are those of box_body() to the last bit.
using WideVector = Eigen::Matrix<Wide, 3, 1>;
using WideMatrix = Eigen::Matrix<Wide, 3, 3>;

// Calls `visit(a, b, c)` for the triangles of all faces, corners relative to `origin`.
template <typename Visit>
void visit_triangles(std::span<const Vector3> vertices, std::span<const std::vector<int>> faces,
                     const WideVector& origin, const Visit& visit) {
    const auto at = [&](int index) -> WideVector {
        return vertices[static_cast<std::size_t>(index)].cast<Wide>() - origin;
    };
    for (const std::vector<int>& face : faces) {
        for (std::size_t i = 2; i < face.size(); ++i) visit(at(face[0]), at(face[i - 1]), at(face[i]));
    }
}

WideVector mean_of(std::span<const Vector3> points) {
    WideVector sum = WideVector::Zero();
    for (const Vector3& point : points) sum += point.cast<Wide>();
    return sum / Wide(static_cast<double>(points.size()));
}

}  // namespace

Solid solid_of(std::span<const Vector3> vertices, std::span<const std::vector<int>> faces) {
    const WideVector inside = mean_of(vertices);
    Wide volume = 0.0;
    WideVector moment = WideVector::Zero();
    visit_triangles(vertices, faces, inside, [&](const WideVector& a, const WideVector& b, const WideVector& c) {
        const Wide part = a.dot(b.cross(c)) / 6.0;
        volume += part;
        moment += part / 4.0 * (a + b + c);
    });
    const WideVector centre = inside + moment / volume;
    WideMatrix second = WideMatrix::Zero();
    visit_triangles(vertices, faces, centre, [&](const WideVector& a, const WideVector& b, const WideVector& c) {
        const WideVector sum = a + b + c;
        const Wide share = a.dot(b.cross(c)) / (volume * 120.0);
        second += share * (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    });
    const WideMatrix inertia = second.trace() * WideMatrix::Identity() - second;
    return {
        .volume = static_cast<double>(volume), .centre = centre.cast<double>(), .inertia = inertia.cast<double>()};
}

PrincipalAxes principal_axes(const Matrix3& inertia) {
    constexpr double rounding = 1e-13;  // of the trace
    constexpr int most_rotations = 60;
    PrincipalAxes result;
    Matrix3 tensor = inertia;
    for (int k = 0; k < most_rotations; ++k) {
        int p = 0, q = 1;
        if (std::abs(tensor(0, 2)) > std::abs(tensor(p, q))) p = 0, q = 2;
        if (std::abs(tensor(1, 2)) > std::abs(tensor(p, q))) p = 1, q = 2;
        const double limit = k == 0 ? rounding : 1e-3 * rounding;
        if (!(std::abs(tensor(p, q)) > limit * tensor.trace())) break;
        const double theta = (tensor(q, q) - tensor(p, p)) / (2.0 * tensor(p, q));
        const double tangent = (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
        const double cosine = 1.0 / std::sqrt(tangent * tangent + 1.0), sine = tangent * cosine;
        Matrix3 turn = Matrix3::Identity();
        turn(p, p) = turn(q, q) = cosine;
        turn(p, q) = sine;
        turn(q, p) = -sine;
        tensor = turn.transpose() * tensor * turn;
        result.axes = result.axes * turn;
    }
    result.moments = tensor.diagonal();
    return result;
}

}  // namespace pushfactor::engine
