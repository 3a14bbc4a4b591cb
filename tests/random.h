// Random numbers for tests: seeded, and the same on every platform.
#pragma once

#include "engine/base/math.h"

#include <random>

namespace pushfactor::tests {

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    double in(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    engine::Vector3 vector(double low, double high) {
        engine::Vector3 v;
        for (double& component : v) component = in(low, high);
        return v;
    }
    engine::Quaternion rotation() {
        engine::Quaternion q;
        do {
            for (double& component : q.coeffs()) component = in(-1, 1);
        } while (q.squaredNorm() > 1.0 || q.squaredNorm() < 0.01);
        return q.normalized();
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace pushfactor::tests
