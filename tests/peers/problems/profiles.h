// Performance profiles: E. Dolan, J. Moré, "Benchmarking optimization software with performance profiles",
// Mathematical Programming 91, 2002.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pushfactor::tests::problems {

// Times of a solver, one per problem [s]; infinite where it failed.
struct SolverTimes {
    std::string name;
    std::vector<double> times;
};

struct Profile {
    std::string name;
    // Corners of a step function from ratio 1 on: the share of the problems (0..1) that this solver solved in at
    // most so many times the time of the fastest one.
    std::vector<std::pair<double, double>> steps;

    double share_within(double ratio) const;
};

// All solvers must have times for the same problems. Problems that none solves count as solved by none.
std::vector<Profile> profiles_of(const std::vector<SolverTimes>& solvers);

}  // namespace pushfactor::tests::problems
