#include "demos/scenes/exact_motions/free_rotation.h"

#include "engine/base/invalid_input.h"
#include "engine/bodies/integrator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace pushfactor::demos::scenes {

namespace elementary = engine::elementary;
using engine::exponential;

using engine::Matrix3;
using engine::Quaternion;
using engine::Vector3;

namespace {

// l' = l x I^-1 l, per axis: l_i' = factor(i) l_j l_k.
double euler_factor(const Vector3& inertia, Eigen::Index axis) {
    return 1.0 / inertia[(axis + 2) % 3] - 1.0 / inertia[(axis + 1) % 3];
}

Eigen::Index middle_axis(const Vector3& inertia) {
    Eigen::Index least = 0, most = 0;
    inertia.minCoeff(&least);
    inertia.maxCoeff(&most);
    return 3 - least - most;
}

void refuse(const char* field, const Vector3& value, const char* allowed) {
    throw engine::InvalidInput(
        field, std::to_string(value.x()) + " " + std::to_string(value.y()) + " " + std::to_string(value.z()),
        allowed);
}

}  // namespace

FreeRotation::FreeRotation(const FreeBody& body) : inertia_(body.inertia) {
    if (!(inertia_.minCoeff() > 0.0) || inertia_[0] == inertia_[1] || inertia_[1] == inertia_[2] ||
        inertia_[2] == inertia_[0]) {
        refuse("inertia", inertia_, "three different moments above zero");
    }
    b_ = middle_axis(inertia_);
    a_ = (b_ + 1) % 3;
    z_ = (b_ + 2) % 3;
    const Vector3 l = inertia_.cwiseProduct(body.angular_rate);
    if (std::abs(l[b_]) > 1e-15 * l.norm() || l[a_] == 0.0 || l[z_] == 0.0) {
        refuse("angular_rate", body.angular_rate,
               "none about the axis of the middle moment, some about the others");
    }
    const auto square = [&](Eigen::Index i, Eigen::Index k) {
        return (euler_factor(inertia_, k) * l[i] * l[i]) / (euler_factor(inertia_, i) * l[k] * l[k]);
    };
    if (square(a_, z_) > 1.0) std::swap(a_, z_);
    parameter_ = square(a_, z_);
    if (!(parameter_ < 1.0)) refuse("angular_rate", body.angular_rate, "other than that of the separatrix");

    rate_ = std::sqrt(-euler_factor(inertia_, a_) * euler_factor(inertia_, b_)) * std::abs(l[z_]);
    l_a_ = l[a_];
    l_z_ = l[z_];
    l_b_ = euler_factor(inertia_, b_) * l_z_ * l_a_ / rate_;
    to_world_ = body.start.toRotationMatrix() * frame(l);
}

Vector3 FreeRotation::momentum(double time) const {
    const Elliptic e = jacobi_elliptic(rate_ * time, parameter_);
    Vector3 l;
    l[a_] = l_a_ * e.cn;
    l[b_] = l_b_ * e.sn;
    l[z_] = l_z_ * e.dn;
    return l;
}

double FreeRotation::precession_rate(double time) const {
    const Vector3 l = momentum(time);
    const double a = l[a_] * l[a_], b = l[b_] * l[b_];
    return l.norm() * (a / inertia_[a_] + b / inertia_[b_]) / (a + b);
}

// Axes in the body frame: the line of phi, l x that line, and l.
Matrix3 FreeRotation::frame(const Vector3& l) const {
    Matrix3 axes;
    axes.col(2) = l.normalized();
    axes.col(0) = Vector3::Unit(z_).cross(l).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return axes;
}

Quaternion FreeRotation::at(double time) {
    // Gauss quadrature with five points, in intervals so short that only rounding is left.
    static constexpr std::array<std::pair<double, double>, 5> points{{{-0.9061798459386640, 0.2369268850561891},
                                                                      {-0.5384693101056831, 0.4786286704993665},
                                                                      {0.0, 0.5688888888888889},
                                                                      {0.5384693101056831, 0.4786286704993665},
                                                                      {0.9061798459386640, 0.2369268850561891}}};
    const int pieces = std::max(1, static_cast<int>(std::ceil(rate_ * (time - time_) / 0.1)));
    const double half = 0.5 * (time - time_) / pieces;
    for (int i = 0; i < pieces; ++i) {
        const double middle = time_ + (2 * i + 1) * half;
        for (const auto& [place, weight] : points) phi_ += half * weight * precession_rate(middle + half * place);
    }
    time_ = time;
    const Matrix3 turn = exponential(phi_ * Vector3::UnitZ()).toRotationMatrix();
    return Quaternion(to_world_ * turn * frame(momentum(time)).transpose()).normalized();
}

Elliptic jacobi_elliptic(double u, double m) {
    constexpr std::size_t most = 16;
    std::array<double, most> means{1.0}, differences{};
    double b = std::sqrt(1.0 - m);
    std::size_t n = 0;
    while (n + 1 < most && means[n] - b > 1e-16 * means[n]) {
        means[n + 1] = 0.5 * (means[n] + b);
        differences[n + 1] = 0.5 * (means[n] - b);
        b = std::sqrt(means[n] * b);
        ++n;
    }
    double phi = std::ldexp(means[n] * u, static_cast<int>(n));
    for (std::size_t i = n; i > 0; --i) {
        const double sine = differences[i] / means[i] * elementary::sin(phi);
        phi = 0.5 * (phi + elementary::atan2(sine, std::sqrt((1.0 - sine) * (1.0 + sine))));
    }
    const double sn = elementary::sin(phi);
    return {sn, elementary::cos(phi), std::sqrt(1.0 - m * sn * sn)};
}

}  // namespace pushfactor::demos::scenes
