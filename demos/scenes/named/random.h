// Random numbers for scenes, the same on every platform (the standard distributions are not).
#pragma once

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

}  // namespace pushfactor::demos::scenes
