#include "tests/peers/problems/profiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pushfactor::tests::problems {

namespace {

double fastest(const std::vector<SolverTimes>& solvers, std::size_t problem) {
    double least = std::numeric_limits<double>::infinity();
    for (const SolverTimes& solver : solvers) least = std::min(least, solver.times[problem]);
    return least;
}

}  // namespace

double Profile::share_within(double ratio) const {
    double share = 0.0;
    for (const auto& [at, value] : steps) {
        if (at <= ratio) share = value;
    }
    return share;
}

std::vector<Profile> profiles_of(const std::vector<SolverTimes>& solvers) {
    std::vector<Profile> profiles;
    for (const SolverTimes& solver : solvers) {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < solver.times.size(); ++i) {
            if (std::isfinite(solver.times[i])) ratios.push_back(solver.times[i] / fastest(solvers, i));
        }
        std::sort(ratios.begin(), ratios.end());
        Profile profile{.name = solver.name, .steps = {{1.0, 0.0}}};
        for (std::size_t i = 0; i < ratios.size(); ++i) {
            profile.steps.emplace_back(ratios[i],
                                       static_cast<double>(i + 1) / static_cast<double>(solver.times.size()));
        }
        profiles.push_back(std::move(profile));
    }
    return profiles;
}

}  // namespace pushfactor::tests::problems
