// Mass properties of homogeneous polyhedra: exact integrals over the solid (paper 3.1 leaves the inertia tensor to
// the reader).
#pragma once

#include "engine/base/math.h"

#include <span>
#include <vector>

namespace pushfactor::engine {

struct Solid {
    double volume = 0.0;                // m^3
    Vector3 centre = Vector3::Zero();   // m, of mass
    Matrix3 inertia = Matrix3::Zero();  // m^2, about the centre, per unit of mass
};

// The faces are loops of vertex indices, counter-clockwise seen from outside, and close the surface. A sum over
// tetrahedra from the centre to the triangles of the faces; for a tetrahedron of volume V with corners 0, a, b, c
// the integral of x x^T is V / 20 (s s^T + a a^T + b b^T + c c^T), s = a + b + c.
Solid solid_of(std::span<const Vector3> vertices, std::span<const std::vector<int>> faces);

// Principal moments of an inertia tensor and the rotation whose columns are their axes.
struct PrincipalAxes {
    Vector3 moments = Vector3::Zero();  // same unit as the tensor
    Matrix3 axes = Matrix3::Identity();
};

// By Jacobi's rotations, each the smaller of the two possible angles, so that the axes stay close to the frame of
// the tensor: a tensor that is diagonal up to rounding keeps its frame exactly.
PrincipalAxes principal_axes(const Matrix3& inertia);

}  // namespace pushfactor::engine
