#include "demos/scenes/exact_motions/hanging_chain.h"

#include "engine/base/elementary.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace pushfactor::demos::scenes {

namespace elementary = engine::elementary;

namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Of each ball and all below it.
VectorXd hanging_masses(const HangingChain& chain) {
    VectorXd sums = chain.masses;
    for (Index i = sums.size() - 2; i >= 0; --i) sums[i] += sums[i + 1];
    return sums;
}

VectorXd accelerations(const HangingChain& chain, const VectorXd& carried, const ChainSwing& swing) {
    const Index n = swing.angles.size();
    const VectorXd sine = swing.angles.unaryExpr(&elementary::sin),
                   cosine = swing.angles.unaryExpr(&elementary::cos);
    Eigen::MatrixXd mass(n, n);
    VectorXd torque(n);
    for (Index i = 0; i < n; ++i) torque[i] = -carried[i] * chain.gravity * chain.lengths[i] * sine[i];
    for (Index j = 0; j < n; ++j) {
        for (Index i = 0; i < n; ++i) {
            const double m = carried[std::max(i, j)] * chain.lengths[i] * chain.lengths[j];
            mass(i, j) = m * (cosine[i] * cosine[j] + sine[i] * sine[j]);
            torque[i] -= m * (sine[i] * cosine[j] - cosine[i] * sine[j]) * swing.rates[j] * swing.rates[j];
        }
        mass(j, j) += chain.moments[j];
    }
    return mass.llt().solve(torque);
}

}  // namespace

ChainSwing advance(const HangingChain& chain, ChainSwing swing, double time, int steps) {
    const VectorXd carried = hanging_masses(chain);
    const double h = time / steps;
    const auto moved = [&](double by, const ChainSwing& rate) {
        return ChainSwing{swing.angles + by * rate.angles, swing.rates + by * rate.rates};
    };
    const auto rate_of = [&](const ChainSwing& at) {
        return ChainSwing{at.rates, accelerations(chain, carried, at)};
    };
    for (int step = 0; step < steps; ++step) {
        const ChainSwing first = rate_of(swing);
        const ChainSwing second = rate_of(moved(0.5 * h, first));
        const ChainSwing third = rate_of(moved(0.5 * h, second));
        const ChainSwing fourth = rate_of(moved(h, third));
        swing.angles += h / 6.0 * (first.angles + 2.0 * (second.angles + third.angles) + fourth.angles);
        swing.rates += h / 6.0 * (first.rates + 2.0 * (second.rates + third.rates) + fourth.rates);
    }
    return swing;
}

std::vector<Eigen::Vector2d> places(const HangingChain& chain, const ChainSwing& swing) {
    std::vector<Eigen::Vector2d> result;
    Eigen::Vector2d end(0, 0);
    for (Index i = 0; i < swing.angles.size(); ++i) {
        end +=
            chain.lengths[i] * Eigen::Vector2d(elementary::sin(swing.angles[i]), -elementary::cos(swing.angles[i]));
        result.push_back(end);
    }
    return result;
}

}  // namespace pushfactor::demos::scenes
