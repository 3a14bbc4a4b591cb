// The items (bodies or colliders, by index) that take part in a step; the others rest (rest.h).
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace pushfactor::engine {

class Awake {
  public:
    Awake() = default;  // no items

    // All of `count` items.
    explicit Awake(std::size_t count) : is_awake_(count, 1), members_(count) {
        std::iota(members_.begin(), members_.end(), 0);
    }

    // Sets some items anew, as `is_awake(item)` says.
    template <typename IsAwake>
    void update(std::span<const int> items, const IsAwake& is_awake) {
        const auto before = static_cast<std::ptrdiff_t>(members_.size());
        bool any_left_out = false;
        for (const int item : items) {
            const bool now = is_awake(item);
            if (now == has(item)) continue;
            is_awake_[static_cast<std::size_t>(item)] = now;
            if (now)
                members_.push_back(item);
            else
                any_left_out = true;
        }
        std::sort(members_.begin() + before, members_.end());
        std::inplace_merge(members_.begin(), members_.begin() + before, members_.end());
        if (any_left_out) std::erase_if(members_, [this](int item) { return !has(item); });
    }

    std::span<const int> members() const { return members_; }  // ascending
    bool has(int number) const { return is_awake_[static_cast<std::size_t>(number)] != 0; }
    std::size_t of() const { return is_awake_.size(); }  // number of items, resting ones included

  private:
    std::vector<char> is_awake_;  // by index
    std::vector<int> members_;
};

// Some bodies of a world by index, or all.
struct SomeBodies {
    bool all = false;
    std::vector<int> some{};
};

}  // namespace pushfactor::engine
