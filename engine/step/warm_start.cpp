#include "engine/step/warm_start.h"

namespace pushfactor::engine {

void WarmStart::begin(std::size_t bodies, std::span<const int> awake) {
    memory_.resize(bodies);
    records_.resize(bodies);
    for (const int body : awake) records_[static_cast<std::size_t>(body)] = {};
}

void WarmStart::solved(const Island& island, const solvers::SolveCount& count, bool outdated) {
    Record record{.in_island = true,
                  .contradicted = count.contradicts,
                  .outdated = outdated,
                  .method = count.in_small_steps   ? Method::in_small_steps
                            : count.exact          ? Method::exact
                            : count.iterations > 0 ? Method::swept
                                                   : Method::kept};
    for (const int body : island.bodies) {
        const Record& before = records_[static_cast<std::size_t>(body)];
        record.method = std::max(record.method, before.method);
        record.outdated = record.outdated || before.outdated;
    }
    for (const int body : island.bodies) records_[static_cast<std::size_t>(body)] = record;
}

void WarmStart::end(std::span<const int> awake) {
    for (const int body : awake) {
        const auto i = static_cast<std::size_t>(body);
        const Record& record = records_[i];
        const bool kept = record.in_island && record.method == Method::kept;
        memory_[i] = {.exact = record.method == Method::exact, .kept = kept ? memory_[i].kept + 1 : 0};
    }
}

}  // namespace pushfactor::engine
