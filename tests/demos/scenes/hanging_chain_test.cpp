// The exact motion of a hanging chain: against closed forms and what is conserved.
#include "demos/scenes/exact_motions/hanging_chain.h"

#include "demos/scenes/exact_motions/ball_on_bar.h"
#include "tests/catch.h"

#include <cmath>
#include <numbers>
#include <tuple>

using namespace pushfactor::demos::scenes;
using Eigen::VectorXd;

namespace {

HangingChain chain_of(int links, double end_mass) {
    HangingChain chain{.lengths = VectorXd::Constant(links, 0.7),
                       .masses = VectorXd::Ones(links),
                       .moments = VectorXd::Zero(links),
                       .gravity = 10.0};
    chain.masses[links - 1] = end_mass;
    return chain;
}

ChainSwing at_rest(int links, double angle) {
    return {VectorXd::Constant(links, angle), VectorXd::Zero(links)};
}

// J, of balls that the bars hold by their centres.
double energy(const HangingChain& chain, const ChainSwing& swing) {
    constexpr double h = 1e-6;
    const auto now = places(chain, swing);
    const auto next = places(chain, {swing.angles + h * swing.rates, swing.rates});
    const auto before = places(chain, {swing.angles - h * swing.rates, swing.rates});
    double sum = 0.0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const double mass = chain.masses[static_cast<Eigen::Index>(i)];
        sum += mass * (chain.gravity * now[i].y() + 0.5 * ((next[i] - before[i]) / (2.0 * h)).squaredNorm());
    }
    return sum;
}

}  // namespace

TEST_CASE("a chain of one ball swings with the period of a pendulum and of a ball that is fixed to its bar") {
    for (const double moment : {0.0, 0.3}) {
        HangingChain chain = chain_of(1, 2.0);
        chain.moments[0] = moment;
        // g / l of the mathematical pendulum with the same period.
        const double reduced = chain.lengths[0] + moment / (chain.masses[0] * chain.lengths[0]);
        const double amplitude = 1.0;
        // By the arithmetic-geometric mean.
        double a = 1.0, b = std::cos(0.5 * amplitude);
        for (int i = 0; i < 8; ++i) std::tie(a, b) = std::pair{0.5 * (a + b), std::sqrt(a * b)};
        const double period = 2.0 * std::numbers::pi * std::sqrt(reduced / chain.gravity) / a;
        const ChainSwing half = advance(chain, at_rest(1, amplitude), 0.5 * period, 2000);
        CHECK(half.angles[0] == Approx(-amplitude).epsilon(1e-9));
        CHECK(std::abs(half.rates[0]) < 1e-7);
    }
}

TEST_CASE("a chain of two balls is a ball on a bar when the first has almost no mass") {
    // There the ball is held by its surface: the second bar is the ball's radius.
    const BallOnBar pendulum{.length = 0.7, .radius = 0.2, .gravity = 10.0};
    HangingChain chain = chain_of(2, 3.0);
    chain.lengths[1] = pendulum.radius;
    chain.masses[0] = 1e-9;
    chain.moments[1] = 0.4 * chain.masses[1] * pendulum.radius * pendulum.radius;
    const Swing exact = advance(pendulum, {.a = 0.8, .b = 0.8}, 1.5, 4000);
    const ChainSwing swing = advance(chain, at_rest(2, 0.8), 1.5, 4000);
    CHECK(swing.angles[0] == Approx(exact.a).epsilon(1e-6));
    CHECK(swing.angles[1] == Approx(exact.b).epsilon(1e-6));
}

TEST_CASE("a chain under a heavy end falls freely at first and keeps its energy") {
    const HangingChain chain = chain_of(20, 1000.0);
    ChainSwing swing = at_rest(20, 0.5 * std::numbers::pi);
    const double begin = energy(chain, swing), scale = 1020.0 * chain.gravity * 14.0;
    swing = advance(chain, swing, 0.01, 64);
    for (const Eigen::Vector2d& place : places(chain, swing))
        CHECK(place.y() == Approx(-0.5 * 10.0 * 1e-4).epsilon(1e-3));
    swing = advance(chain, swing, 2.0, 7680);
    CHECK(std::abs(energy(chain, swing) - begin) < 1e-7 * scale);
    CHECK(places(chain, swing).back().y() < -5.0);
}
