// Random numbers for scenes, the same on every platform (the standard distributions are not).
#pragma once

#include "engine/base/math.h"

#include <cstdint>
#include <random>

namespace pushfactor::demos::scenes {

class Random {
  public:
    explicit Random(int seed) : engine_(static_cast<std::uint64_t>(seed)) {}

    // Uniform in [low, high). One call per statement: the order within an argument list is unspecified.
    double in(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }

  private:
    std::mt19937_64 engine_;
};

// Every orientation is equally likely.
inline engine::Quaternion random_orientation(Random& random) {
    engine::Quaternion q;
    do {
        for (double& component : q.coeffs()) component = random.in(-1.0, 1.0);
    } while (q.squaredNorm() > 1.0 || q.squaredNorm() < 0.01);
    return q.normalized();
}

}  // namespace pushfactor::demos::scenes
