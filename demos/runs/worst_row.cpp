#include "demos/runs/worst_row.h"

namespace pushfactor::demos {

namespace {

using engine::Vector6;

using IslandOutcome = engine::IslandSolver::Outcome;

// The bodies of the row with the largest residual in the islands whose outcome is `concerned`.
template <typename Concerned>
std::optional<BodyPair> worst_among(const engine::World& world, Concerned concerned) {
    const engine::SystemEquation& system = world.system();
    const engine::Columns& lambda = world.lambda();
    // M^-1 J^T lambda, one per body; zero for static ones
    std::vector<Vector6> accelerations(system.inverse_mass.size(), Vector6::Zero());
    std::optional<BodyPair> worst;
    double largest = 0.0;  // m/s
    const auto look_at = [&](int j, Eigen::Index column, engine::RowResiduals& residuals) {
        const engine::ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
        const double w = row.jacobian.a.dot(accelerations[static_cast<std::size_t>(row.body_a)]) +
                         row.jacobian.b.dot(accelerations[static_cast<std::size_t>(row.body_b)]) -
                         system.b(j, column) + soft_part(row, lambda, j, column);
        const double miss = residuals.next(j, w);
        if (miss <= largest) return;
        largest = miss;
        worst = BodyPair{row.body_a, row.body_b};
    };
    for (const engine::Island& island : world.islands().all()) {
        if (!concerned(world.outcome_of(island))) continue;
        for (Eigen::Index column = 0; column < island.columns; ++column) {
            constraint_forces(system, island, lambda, column, accelerations);
            for (const int body : island.bodies) {
                Vector6& own = accelerations[static_cast<std::size_t>(body)];
                own = accelerate(system.inverse_mass[static_cast<std::size_t>(body)], own);
            }
            engine::RowResiduals residuals(system, lambda, column);
            for (const engine::RowRun& run : island.runs) {
                for (int j = run.begin; j < run.end; ++j) look_at(j, column, residuals);
            }
        }
    }
    return worst;
}

}  // namespace

std::optional<BodyPair> worst_unsolved(const engine::World& world) {
    return worst_among(world, [](const IslandOutcome& outcome) { return !outcome.solved; });
}

std::optional<BodyPair> worst_contradicting(const engine::World& world) {
    return worst_among(world, [](const IslandOutcome& outcome) { return outcome.contradicts; });
}

}  // namespace pushfactor::demos
