// How far bodies are from their measured motion.
#pragma once

#include "demos/runs/simulation.h"

#include <vector>

namespace pushfactor::demos {

struct MeasuredError {
    std::size_t body = 0;
    double distance = 0.0;  // m, between the centres
    double angle = 0.0;     // degrees, of the turn from one orientation to the other
};

class MeasuredErrors {
  public:
    explicit MeasuredErrors(const BuiltScene& scene);

    // Whether the scene has no measured motion.
    bool empty() const { return pairs_.empty(); }

    // Of the bodies whose measured motion has not ended.
    std::vector<MeasuredError> at(const Simulation& simulation) const;

  private:
    struct Pair {
        std::size_t body = 0, measured = 0;
        double until = 0.0;  // s
    };
    std::vector<Pair> pairs_;
};

// Over all bodies and steps of a run.
struct MeasuredSum {
    long count = 0;
    double distance = 0.0, angle = 0.0;                  // sums
    double largest_distance = 0.0, largest_angle = 0.0;  // m, degrees

    void add(const std::vector<MeasuredError>& errors);
};

}  // namespace pushfactor::demos
