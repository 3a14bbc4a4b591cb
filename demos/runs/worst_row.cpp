#include "demos/runs/worst_row.h"

namespace pushfactor::demos {

namespace {

using engine::Vector6;

using IslandOutcome = engine::IslandSolver::Outcome;

class Search {
  public:
    explicit Search(const engine::World& world) : system_(world.system()), lambda_(world.lambda()) {}

    void look_at(const engine::Island& island) {
        accelerations_.resize(system_.inverse_mass.size(), Vector6::Zero());
        for (Eigen::Index column = 0; column < island.columns; ++column) {
            constraint_forces(system_, island, lambda_, column, accelerations_);
            for (const int body : island.bodies) {
                Vector6& own = accelerations_[static_cast<std::size_t>(body)];
                own = accelerate(system_.inverse_mass[static_cast<std::size_t>(body)], own);
            }
            engine::RowResiduals residuals(system_, lambda_, column);
            for (const engine::RowRun& run : island.runs) {
                for (int j = run.begin; j < run.end; ++j) look_at(j, column, residuals);
            }
        }
    }

    const std::optional<BodyPair>& found() const { return found_; }

  private:
    void look_at(int j, Eigen::Index column, engine::RowResiduals& residuals) {
        const engine::ConstraintRow& row = system_.rows[static_cast<std::size_t>(j)];
        const double w = row.jacobian.a.dot(accelerations_[static_cast<std::size_t>(row.body_a)]) +
                         row.jacobian.b.dot(accelerations_[static_cast<std::size_t>(row.body_b)]) -
                         system_.b(j, column) + soft_part(row, lambda_, j, column);
        const double miss = residuals.next(j, w);
        if (miss <= largest_) return;
        largest_ = miss;
        found_ = BodyPair{row.body_a, row.body_b};
    }

    const engine::SystemEquation& system_;
    const engine::Columns& lambda_;
    std::vector<Vector6> accelerations_;  // M^-1 J^T lambda, one per body; zero for static ones
    double largest_ = 0.0;                // m/s
    std::optional<BodyPair> found_;
};

template <typename Concerned>
std::optional<BodyPair> worst_among(const engine::World& world, Concerned concerned) {
    Search search(world);
    for (const engine::Island& island : world.islands().all()) {
        if (concerned(world.outcome_of(island))) search.look_at(island);
    }
    return search.found();
}

}  // namespace

std::optional<BodyPair> worst_unsolved(const engine::World& world) {
    return worst_among(world, [](const IslandOutcome& outcome) { return !outcome.solved; });
}

std::optional<BodyPair> worst_contradicting(const engine::World& world) {
    return worst_among(world, [](const IslandOutcome& outcome) { return outcome.contradicts; });
}

}  // namespace pushfactor::demos
