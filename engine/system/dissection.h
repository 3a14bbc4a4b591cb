// A large island in parts that threads can work on at the same time (nested dissection, George 1973).
//
// Upright planes halve the bodies, then each half, and so on. The rows between bodies of one leaf touch no other
// leaf; a row across a plane belongs to that plane. So the rows of all leaves can be gone through at the same time,
// then those of all planes that halve the smallest parts, and the one plane through the whole island last. It is
// the order of the rows that is changed, and by the places of the bodies alone, so the bits do not depend on how
// many threads there are.
//
// Within a part the order is that of the step: from the bottom up load still travels through a heap in one sweep,
// because the planes are upright, and sweeps get as far as before. A colouring, which groups rows without common
// bodies, loses that.
#pragma once

#include "engine/base/threads.h"
#include "engine/bodies/body.h"
#include "engine/system/islands.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace pushfactor::engine {

class Dissection {
  public:
    // Rows next to each other, in the new order, that one thread goes through.
    struct Part {
        int begin_run = 0, end_run = 0;  // of island().runs
        int begin_row = 0, end_row = 0;  // numbers in island()
    };
    // Bodies of one leaf, in the new order.
    struct Leaf {
        int begin = 0, end = 0;  // numbers in island()
    };
    // Parts that have no body in common.
    struct Round {
        std::span<const Part> parts{};
    };

    // Rows from which on an island is cut.
    static constexpr int least_rows = 2000;

    // Cuts `island`, of which `bodies` of the world are where they are; an island that is small, too narrow to be
    // cut upright, or whose rows follow those of other bodies becomes one part in the order that it has.
    void cut(std::span<const Body> bodies, const Island& island);

    // The island that was cut, with its bodies and runs in the new order; rows keep their indices in the step. Its
    // runs do not ascend, so number_of() is not to be asked of it. Good until the next cut().
    const Island& island() const { return island_; }
    std::span<const Round> rounds() const { return rounds_; }
    std::span<const Leaf> leaves() const { return leaves_; }
    std::size_t part_count() const { return parts_.size(); }
    // The place of a part among all of them, below part_count().
    std::size_t number_of(const Part& part) const { return static_cast<std::size_t>(&part - parts_.data()); }

    // Calls `visit(part)` with all parts of this member of the team, round after round.
    template <typename Visit>
    void by_rounds(Team& team, const Visit& visit) const {
        for (const Round& round : rounds_) {
            in_any_order(team, round, visit);
            team.wait_for_all();
        }
    }

    // The same where parts may share bodies, because nothing is written to them.
    template <typename Visit>
    void in_any_order(Team& team, const Visit& visit) const {
        for (const Round& round : rounds_) in_any_order(team, round, visit);
    }

    // Calls `visit(leaf, its place)` with all leaves of this member.
    template <typename Visit>
    void by_leaves(Team& team, const Visit& visit) const {
        for (std::size_t k = 0; k < leaves_.size(); ++k) {
            if (team.owns(k, leaves_.size())) visit(leaves_[k], k);
        }
    }

  private:
    template <typename Visit>
    void in_any_order(Team& team, const Round& round, const Visit& visit) const {
        for (std::size_t k = 0; k < round.parts.size(); ++k) {
            if (team.owns(k, round.parts.size())) visit(round.parts[k]);
        }
    }

    // A movable body of the island, and where it is seen from above [m].
    struct Spot {
        std::array<double, 2> place;
        int body;  // old number
    };

    void leave_whole(const Island& island);
    bool halve(int begin, int end, int halvings, int leaf);
    void put_bodies(const Island& island, int halvings);
    bool put_runs(const Island& island, int halvings);
    void list_parts();

    Island island_;
    std::vector<int> bodies_;  // of island_
    std::vector<RowRun> runs_;
    std::vector<Leaf> leaves_;
    std::vector<Part> parts_;  // of all rounds
    std::vector<Round> rounds_;
    std::vector<Spot> spots_;
    std::vector<int> leaf_of_;  // by old number of a movable body
    std::vector<int> number_;   // new, by old one
    std::vector<int> part_of_;  // by old place of a run
    std::vector<int> begin_;    // by part, where its runs begin, and where the last one's end
    std::vector<int> next_;     // by leaf or part, while its bodies or runs are put there
};

}  // namespace pushfactor::engine
