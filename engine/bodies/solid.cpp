#include "engine/bodies/solid.h"

#include <cmath>

namespace pushfactor::engine {

namespace {

// Calls `visit(a, b, c)` for the triangles of all faces, corners relative to `origin`.
template <typename Visit>
void visit_triangles(std::span<const Vector3> vertices, std::span<const std::vector<int>> faces,
                     const Vector3& origin, const Visit& visit) {
    const auto at = [&](int index) -> Vector3 { return vertices[static_cast<std::size_t>(index)] - origin; };
    for (const std::vector<int>& face : faces) {
        for (std::size_t i = 2; i < face.size(); ++i) visit(at(face[0]), at(face[i - 1]), at(face[i]));
    }
}

Vector3 mean_of(std::span<const Vector3> points) {
    Vector3 sum = Vector3::Zero();
    for (const Vector3& point : points) sum += point;
    return sum / static_cast<double>(points.size());
}

}  // namespace

Solid solid_of(std::span<const Vector3> vertices, std::span<const std::vector<int>> faces) {
    Solid solid;
    const Vector3 inside = mean_of(vertices);
    Vector3 moment = Vector3::Zero();
    visit_triangles(vertices, faces, inside, [&](const Vector3& a, const Vector3& b, const Vector3& c) {
        const double volume = a.dot(b.cross(c)) / 6.0;
        solid.volume += volume;
        moment += (0.25 * volume) * (a + b + c);
    });
    solid.centre = inside + moment / solid.volume;
    Matrix3 second = Matrix3::Zero();
    visit_triangles(vertices, faces, solid.centre, [&](const Vector3& a, const Vector3& b, const Vector3& c) {
        const Vector3 sum = a + b + c;
        const double share = a.dot(b.cross(c)) / (120.0 * solid.volume);
        second += share * (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    });
    solid.inertia = second.trace() * Matrix3::Identity() - second;
    return solid;
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
