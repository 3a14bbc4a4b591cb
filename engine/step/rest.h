// Rest (sleeping): bodies that hold each other and have not moved for a while lose their momenta and take part in
// no step until something wakes them. Their forces are kept, so that they continue as if they had never been left
// out.
//
// "Not moved" refers to positions, not velocities: the single-frame push (8.1) separates overlaps without any
// velocity. In 0.5 s a body may move by 1e-5 of its size. That alone would stop what is about to turn back, begins
// to slide or tips slowly; so each body of the group also has to be in equilibrium, with a net force below 1e-6 of
// its weight. Bodies that nothing static holds never rest.
//
// A ball that turns in place moves nothing either, e.g. one pinched between two others, whose turn about the line
// through both contacts is not braked: while its spin is constant it counts as still, and it goes on turning while
// it and everything around it rest. It keeps its angular momentum.
//
// Rows without any force do not connect bodies here: a body that rolls by within the margin neither keeps others
// awake nor wakes them. So groups of bodies that push each other come to rest, which are parts of islands.
//
// A group wakes as a whole: when a row with an awake body has a force on it, while the group counts as static; when
// a source says that a force on it changes; or when wake() is called. Until then its state is constant, so it
// cannot wake by itself.
//
// Not from the paper, which measures how long a stack stands without it.
#pragma once

#include "engine/bodies/body.h"
#include "engine/step/step_solver.h"
#include "engine/system/system_equation.h"

#include <span>
#include <vector>

namespace pushfactor::engine {

class Rest {
  public:
    // State per body that is carried to the next step.
    struct Memory {
        int group = -1;      // at rest: number shared by bodies that came to rest together; negative otherwise
        double still = 0.0;  // s, for which it has moved by at most the bound in any while (constants::rest::time)
        double here = 0.0;   // s, for which it has been within the bound of this place
        Vector3 position = Vector3::Zero();  // m
        Quaternion orientation = Quaternion::Identity();
        Vector3 spin = Vector3::Zero();  // kg m^2/s, angular momentum kept by a body whose turning no row sees
    };

    bool is_at_rest(int body) const {
        return static_cast<std::size_t>(body) < memory_.size() &&
               memory_[static_cast<std::size_t>(body)].group >= 0;
    }
    // Whether the body has been still for long enough.
    bool is_still(int body) const;
    int count() const { return count_; }  // bodies at rest
    // Bodies that have woken or come to rest since the last call, or both.
    std::vector<int> take_changed();

    // Wakes a body and its group. For an awake body, restarts its time.
    void wake(int body);
    void wake_all();
    // Wakes groups that awake movable bodies push with the forces `lambda` of the rows of `system`. Returns whether
    // there were any.
    bool wake_pushed(const SystemEquation& system, const Columns& lambda);

    // Resting bodies that go on turning; valid until the next end_step() or wake().
    std::span<const int> turning() const { return turning_; }

    // After a step of `dt` [s] with these rows and forces: records the positions of the bodies that took part, and
    // brings groups to rest that have been still for long enough and are held by something static other than a
    // running belt or a moved body. `turns_unseen`, by body: no row depends on its orientation.
    void end_step(std::span<Body> bodies, std::span<const char> turns_unseen, const SystemEquation& system,
                  const StepSolver& solved, double dt);

    std::span<const Memory> memory() const { return memory_; }  // by body; empty before the first step
    void set_memory(std::span<const Memory> memory, std::span<const Body> bodies);

  private:
    // A group of bodies of an island that push each other (union-find, by number in the island).
    struct Group {
        int parent = 0;
        bool may_rest = true;
        bool is_held = false;
    };

    void note_places(std::span<const Body> bodies, std::span<const char> turns_unseen, std::span<const int> awake,
                     double dt);
    void list_turning(std::span<const Body> bodies);
    void join_group(int body, int leader);
    void find_groups(std::span<const Body> bodies, const SystemEquation& system, const StepSolver& solved,
                     const Island& island);
    int root_of(int number);
    void bring_to_rest(std::span<Body> bodies, const Island& island);

    std::vector<Memory> memory_;
    std::vector<int> next_;      // by body: the next one of its group, around; itself if it is awake
    std::vector<Group> groups_;  // of the current island
    std::vector<int> turning_;
    int count_ = 0;
    std::vector<int> changed_;
};

}  // namespace pushfactor::engine
