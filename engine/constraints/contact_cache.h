// Contact caching, paper section 6.2.3: the forces of the previous step as the guess of this one.
#pragma once

#include "engine/base/threads.h"
#include "engine/collision/detector.h"
#include "engine/constraints/constraint_row.h"

#include <span>
#include <utility>
#include <vector>

namespace pushfactor::engine {

// The force at one contact point in both columns [N]. The friction part is a vector in the world frame, because
// the tangents may turn from step to step.
struct ContactForce {
    Lambda normal;
    Vector3 friction_first = Vector3::Zero();
    Vector3 friction_last = Vector3::Zero();
};

class ContactCache {
  public:
    struct Point {
        // Not defaulted: a vector would fill all of it with zeros before its members get their values.
        Point() {}  // NOLINT(modernize-use-equals-default)
        Point(std::uint32_t of, const Vector3& at, const ContactForce& with)
            : feature(of), position(at), force(with) {}

        std::uint32_t feature = 0;
        Vector3 position;  // m, world frame
        ContactForce force;
    };
    struct Entry {
        collision::Pair pair;
        std::size_t first = 0;  // into points()
        int count = 0;
    };

    // Appends the cached force for every point of `touches`, point after point; zero where nothing matches. A point
    // is the same as before when its feature is, or else when it is the nearest one within 2 % of the size. No
    // force is given to two points. `threads` share the work; null: one thread.
    void recall(std::span<const collision::Touch> touches, std::vector<ContactForce>& forces,
                Threads* threads = nullptr);

    // Replaces the cache. `forces` in the order of recall.
    void store(std::span<const collision::Touch> touches, std::span<const ContactForce> forces,
               Threads* threads = nullptr);

    // The same touch after touch, in ascending order of the pair, once the cache is empty. `forces`: one per point.
    void clear();
    void store(const collision::Touch& touch, std::span<const ContactForce> forces);

    // What is stored, for whoever saves and restores a run: ascending pairs, and the points of all of them.
    std::span<const Entry> entries() const { return entries_; }
    std::span<const Point> points() const { return points_; }

    // Moves into this cache what `from` has of the pairs that `belongs` says so of.
    template <typename Belongs>
    void take_from(ContactCache& from, const Belongs& belongs) {
        ContactCache left, mine;
        auto own = entries_.begin();
        for (const Entry& entry : from.entries_) {
            const bool moves = belongs(entry.pair);
            for (; moves && own != entries_.end() && own->pair < entry.pair; ++own) mine.add(own->pair, of(*own));
            (moves ? mine : left).add(entry.pair, from.of(entry));
        }
        for (; own != entries_.end(); ++own) mine.add(own->pair, of(*own));
        *this = std::move(mine);
        from = std::move(left);
    }

    std::span<const Point> of(const Entry& entry) const {
        return std::span(points_).subspan(entry.first, static_cast<std::size_t>(entry.count));
    }

    // Appends an entry; its pair must be greater than those before.
    void add(const collision::Pair& pair, std::span<const Point> points);

  private:
    // Of the touch at hand: forces of before, points of now.
    struct Matched {
        std::vector<char> taken, given;
    };

    void recall(std::span<const collision::Touch> touches, std::span<ContactForce> forces, Matched& matched) const;
    bool is_as_before(const Entry& entry, std::span<const collision::ContactPoint> points) const;
    void hand_out(const Entry& entry, std::span<const collision::ContactPoint> points, double reach,
                  std::span<ContactForce> forces, Matched& matched) const;

    std::vector<Entry> entries_;  // ascending pairs
    std::vector<Point> points_;
    // By part of the touches:
    std::vector<std::size_t> first_force_;
    std::vector<Matched> matched_;
};

}  // namespace pushfactor::engine
