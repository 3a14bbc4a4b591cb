// Nested dissection (George 1973): cuts a large island into parts that threads can work on concurrently.
//
// Vertical planes across the longest extent bisect the bodies, then each half, and so on. Vertical is the sum of
// the external forces on the island; without any there is no such direction, and the planes are only across the
// longest extent. So nothing depends on the axes of the world. Rows between bodies of one leaf touch no other leaf;
// a row across a plane belongs to that plane. So the rows of all leaves can be processed concurrently, then those
// of all planes of the lowest level, and so on up to the one plane through the whole island. This changes only the
// order of the rows, and depends only on the positions of the bodies, so results do not depend on the number of
// threads.
//
// Within a part the order is that of the step: since the planes are vertical, load still travels through a heap
// from the bottom up in one sweep, and sweeps converge as fast as before. A colouring, which groups rows without
// common bodies, loses that.
#pragma once

#include "engine/base/threads.h"
#include "engine/bodies/body.h"
#include "engine/system/islands.h"

#include <cstddef>
#include <span>
#include <vector>

namespace pushfactor::engine {

class Dissection {
  public:
    // Consecutive rows in the new order, processed by one thread.
    struct Part {
        std::span<const RowRun> runs{};  // of island()
    };
    // Bodies of one leaf, consecutive in the new order.
    struct Leaf {
        int begin = 0, end = 0;  // body numbers in island()
    };
    // Parts without common bodies.
    using Round = std::span<const Part>;

    // Number of rows from which on an island is cut.
    static constexpr int least_rows = 2000;

    // Cuts `island` by the positions of `bodies` (of the world, with the external forces). An island that is small,
    // too narrow for vertical cuts, or has rows whose bounds follow rows of other bodies becomes one part in its
    // original order.
    void cut(std::span<const Body> bodies, const Island& island);

    // The cut island, with bodies and runs in the new order; rows keep their indices in the step. Its runs do not
    // ascend, so Island::number_of() is invalid. Valid until the next cut().
    const Island& island() const { return island_; }
    std::span<const Round> rounds() const { return rounds_; }
    std::span<const Leaf> leaves() const { return leaves_; }
    std::size_t part_count() const { return parts_.size(); }
    // Index of a part, below part_count().
    std::size_t number_of(const Part& part) const { return static_cast<std::size_t>(&part - parts_.data()); }

    // Calls `visit(part)` for all parts of this member of the team, round by round, with a barrier after each.
    template <typename Visit>
    void by_rounds(Team& team, const Visit& visit) const {
        for (const Round& round : rounds_) {
            in_any_order(team, round, visit);
            team.wait_for_all();
        }
    }

    // Without barriers: parts may share bodies, so `visit` must not write to them.
    template <typename Visit>
    void in_any_order(Team& team, const Visit& visit) const {
        for (const Round& round : rounds_) in_any_order(team, round, visit);
    }

    // Calls `visit(leaf, index)` for all leaves of this member.
    template <typename Visit>
    void by_leaves(Team& team, const Visit& visit) const {
        for (std::size_t k = 0; k < leaves_.size(); ++k) {
            if (team.owns(k, leaves_.size())) visit(leaves_[k], k);
        }
    }

  private:
    template <typename Visit>
    void in_any_order(Team& team, const Round& round, const Visit& visit) const {
        for (std::size_t k = 0; k < round.size(); ++k) {
            if (team.owns(k, round.size())) visit(round[k]);
        }
    }

    // A movable body of the island.
    struct Spot {
        Vector3 position;    // m, from the first body, without its vertical part
        int body;            // old number
        double place = 0.0;  // m, across the plane that is being placed
    };

    void find_spots(std::span<const Body> bodies, const Island& island);
    void leave_whole(const Island& island);
    static Vector3 long_axis(std::span<const Spot> spots);
    bool halve(int begin, int end, int halvings, int leaf);
    void put_bodies(const Island& island, int halvings);
    bool put_runs(const Island& island, int halvings);

    Island island_;
    std::vector<int> bodies_;  // of island_
    std::vector<RowRun> runs_;
    std::vector<Leaf> leaves_;
    std::vector<Part> parts_;  // of all rounds
    std::vector<Round> rounds_;
    std::vector<Spot> spots_;
    std::vector<double> places_;
    double reach_ = 0.0;        // m, of the farthest body from the first one
    std::vector<int> leaf_of_;  // by old number of a movable body
    std::vector<int> number_;   // new number, by old one
    std::vector<int> part_of_;  // by old index of a run
    std::vector<int> begin_;    // by part, first run; and the end of the last one
    std::vector<int> next_;     // by leaf or part, next free place while filling
};

}  // namespace pushfactor::engine
