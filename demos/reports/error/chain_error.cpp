// The chain against the exact motion of balls on massless bars.
#include "demos/reports/error/true_errors.h"
#include "demos/scenes/exact_motions/hanging_chain.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::demos::reports::error {

namespace {

using engine::Body;
using engine::Vector3;

// Without the body of the world, from which the chain hangs.
std::vector<Body> balls(const Simulation& simulation) {
    std::vector<Body> movable;
    for (const Body& body : simulation.scene().world.bodies) {
        if (!body.is_static()) movable.push_back(body);
    }
    return movable;
}

class ChainError : public TrueError {
  public:
    explicit ChainError(const Simulation& start) {
        const std::vector<Body> bodies = balls(start);
        const auto count = static_cast<Eigen::Index>(bodies.size());
        chain_ = {.lengths = Eigen::VectorXd(count),
                  .masses = Eigen::VectorXd(count),
                  .moments = Eigen::VectorXd::Zero(count),  // bars hold the centres
                  .gravity = start.scene().gravity.norm()};
        swing_ = {.angles = Eigen::VectorXd(count), .rates = Eigen::VectorXd::Zero(count)};
        Vector3 above = Vector3::Zero();
        for (Eigen::Index i = 0; i < count; ++i) {
            const Body& ball = bodies[static_cast<std::size_t>(i)];
            const Vector3 bar = ball.position - above;
            chain_.lengths[i] = bar.norm();
            chain_.masses[i] = ball.mass();
            swing_.angles[i] = std::atan2(bar.x(), -bar.y());
            above = ball.position;
        }
    }

    void observe(const Simulation& simulation) override {
        const double dt = simulation.settings().dt.value();
        swing_ =
            advance(chain_, std::move(swing_), dt, std::max(1, static_cast<int>(std::lround(dt / longest_step))));
        const std::vector<Eigen::Vector2d> exact = places(chain_, swing_);
        const std::vector<Body> bodies = balls(simulation);
        for (std::size_t i = 0; i < exact.size(); ++i) {
            const double square = (bodies[i].position - Vector3(exact[i].x(), exact[i].y(), 0.0)).squaredNorm();
            distance_.add(square);
            last_ = i + 1 == exact.size() ? std::sqrt(square) : last_;
        }
    }

    std::vector<NamedError> result() const override {
        return {{"position_rms_m", distance_.value()}, {"end_of_chain_m", last_}};
    }

  private:
    // s, of the exact motion: its own error is some 1e-11 m, below that of the finest runs.
    static constexpr double longest_step = 1.0 / 15360.0;

    scenes::HangingChain chain_;
    scenes::ChainSwing swing_;
    Rms distance_;
    double last_ = 0.0;  // m, of the lowest ball after the last step
};

}  // namespace

std::unique_ptr<TrueError> chain_error(const Simulation& start) {
    return std::make_unique<ChainError>(start);
}

}  // namespace pushfactor::demos::reports::error
