// Whether colour-blind readers can tell the colours apart.
#include "demos/base/text/palette.h"

#include "tests/catch.h"

#include <Eigen/Core>

#include <cmath>

using namespace pushfactor::demos;

namespace {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

Vector3 linear(const Colour& colour) {
    const auto part = [](float c) { return c <= 0.04045f ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return {part(colour.red), part(colour.green), part(colour.blue)};
}

// CIE L*a*b* of a linear sRGB colour, in which a distance of about 2.3 is just noticeable.
Vector3 lab(const Vector3& rgb) {
    Matrix3 to_xyz;
    to_xyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
    const Vector3 white(0.9505, 1.0, 1.089);
    const Vector3 xyz = (to_xyz * rgb.cwiseMax(0.0).cwiseMin(1.0)).cwiseQuotient(white);
    const Vector3 f =
        xyz.unaryExpr([](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; });
    return {116.0 * f.y() - 16.0, 500.0 * (f.x() - f.y()), 200.0 * (f.y() - f.z())};
}

// Machado, Oliveira & Fernandes (2009), severity 1, on linear sRGB.
Matrix3 sight(const std::string& kind) {
    Matrix3 m = Matrix3::Identity();
    if (kind == "protanopia")
        m << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
    if (kind == "deuteranopia")
        m << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
    if (kind == "tritanopia")
        m << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
    return m;
}

}  // namespace

TEST_CASE("any two colours of the palette are told apart by the colour-blind too") {
    for (const std::string kind : {"full sight", "protanopia", "deuteranopia", "tritanopia"}) {
        for (std::size_t i = 0; i < palette.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                INFO(kind << ": " << palette[i].name << " and " << palette[j].name);
                const Vector3 a = lab(sight(kind) * linear(palette[i]));
                const Vector3 b = lab(sight(kind) * linear(palette[j]));
                CHECK((a - b).norm() > 15.0);  // 17.3 is the smallest, of blue and green under tritanopia
            }
        }
    }
}
