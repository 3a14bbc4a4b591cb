// Which of many numbered things (bodies, colliders) take part in a step, where others rest (rest.h).
#pragma once

#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace pushfactor::engine {

class Awake {
  public:
    Awake() = default;  // of nothing

    // All of `count`.
    explicit Awake(std::size_t count) : is_awake_(count, 1), members_(count) {
        std::iota(members_.begin(), members_.end(), 0);
    }

    // Those of which `is_awake` says so, by number.
    explicit Awake(std::vector<char> is_awake) : is_awake_(std::move(is_awake)) {
        for (std::size_t i = 0; i < is_awake_.size(); ++i) {
            if (is_awake_[i]) members_.push_back(static_cast<int>(i));
        }
    }

    std::span<const int> members() const { return members_; }  // ascending
    bool has(int number) const { return is_awake_[static_cast<std::size_t>(number)] != 0; }
    std::size_t of() const { return is_awake_.size(); }  // the others included

  private:
    std::vector<char> is_awake_;  // by number
    std::vector<int> members_;
};

// Some bodies of a world by their numbers, or all.
struct SomeBodies {
    bool all = false;
    std::vector<int> some{};
};

}  // namespace pushfactor::engine
