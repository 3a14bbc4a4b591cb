// Rest: bodies that hold each other and have stayed where they are for a while lose their momenta, and take
// part in no step until something wakes them. The forces that held them stay remembered, so that they go on as if
// they had never been left out.
//
// "Where they are" is a matter of places, not of velocities: under the single-frame push (8.1) what overlaps parts
// without any. Two spans are looked at, so that what has begun to slide, roll or tip is not held: in half a second
// a body may move by a hundred-thousandth of its size, which an acceleration of 8 bound / time^2 = 3e-4 m/s^2 a
// metre leaves; in 16 seconds by 8 % of it (2.5e-3 m/s^2), for a ball that rocks in a hollow of a heap that stands:
// that never ends where nothing brakes rolling. What nothing static holds never rests.
//
// A ball that turns in place, as one that is pinched between two others does for ever because nothing brakes a turn
// about the line through both contacts, moves nothing either: as long as its spin stays the same it counts as
// still, and it goes on turning while it and all around it rest. It keeps its angular momentum. One whose turn goes
// to and fro in its place, as when it is pinched a little beside its middle, counts as still in the long span.
//
// Bodies that rows join without any force push nothing: what rolls by at the distance of the margin neither keeps
// awake nor wakes. So it is groups of bodies that push each other which come to rest, parts of islands.
//
// A group wakes as a whole: when a row with a body that is awake has a force, while the group is taken for static;
// when a source says that a force on it acts otherwise from now on; or when wake() is called. Until then nothing
// about it changes, so that it cannot wake by itself.
//
// Not from the paper, which measures how long a stack stands without it.
#pragma once

#include "engine/bodies/awake.h"
#include "engine/bodies/body.h"
#include "engine/system/islands.h"
#include "engine/system/system_equation.h"

#include <array>
#include <span>
#include <vector>

namespace pushfactor::engine {

class Rest {
  public:
    struct Span {
        double time;         // s
        double bound;        // of the size of a body
        double unseen_turn;  // rad, for what turns unseen; less than half a turn, so that none goes round and round
    };
    static constexpr std::array<Span, 2> spans{{{0.5, 1e-5, 0.0}, {8.0, 2e-2, 2.5}}};

    // Where a body has been within the bound of a span, and since when.
    struct Stay {
        double still = 0.0;                  // s
        Vector3 position = Vector3::Zero();  // m
        Quaternion orientation = Quaternion::Identity();
        Vector3 spin = Vector3::Zero();  // kg m^2/s, angular momentum that a body has kept which turns unseen
    };
    // What the next step has to know of a body.
    struct Memory {
        int group = -1;  // at rest: a number that those have in common that came to rest together; else below 0
        std::array<Stay, spans.size()> stays{};
    };

    bool is_at_rest(int body) const {
        return static_cast<std::size_t>(body) < memory_.size() &&
               memory_[static_cast<std::size_t>(body)].group >= 0;
    }
    // Whether the body has stayed for as long as its whole group has to.
    bool is_still(int body) const;
    int count() const { return count_; }  // bodies at rest
    // All others, of `bodies` in the world.
    Awake awake(std::size_t bodies) const;
    // Whether that has changed since the last call of this.
    bool take_change();

    // Wakes a body with all that came to rest with it. Of one that is awake, begins its time anew.
    void wake(int body);
    void wake_all();
    // Wakes what bodies that can move and are awake push, with the forces `lambda` of the rows of `system`. Returns
    // whether there was something.
    bool wake_pushed(const SystemEquation& system, const Columns& lambda);

    // Those at rest that go on turning; good until the next end_step() or wake().
    std::span<const int> turning() const { return turning_; }

    // After a step of `dt` [s] with these rows and forces: takes note of where the bodies that took part are, and
    // brings those groups to rest that have been still for long enough and are held by something static, but not
    // by a belt that runs. `turns_unseen`, by body: whether no row depends on how it is turned.
    void end_step(std::span<Body> bodies, std::span<const char> turns_unseen, const SystemEquation& system,
                  const Islands& islands, const Columns& lambda, double dt);

    std::span<const Memory> memory() const { return memory_; }  // by body; empty before the first step
    void set_memory(std::span<const Memory> memory, std::span<const Body> bodies);

  private:
    // Of the bodies of an island that push each other, by the number of one of them in the island.
    struct Group {
        int parent = 0;
        bool may_rest = true;
        bool is_held = false;
    };

    void note_places(std::span<const Body> bodies, std::span<const char> turns_unseen, std::span<const int> awake,
                     double dt);
    bool turns_on(const Body& body, const Memory& memory) const;
    void list_turning(std::span<const Body> bodies);
    void find_groups(const SystemEquation& system, const Island& island, const Columns& lambda);
    int root_of(int number);
    void bring_to_rest(std::span<Body> bodies, const Island& island);

    std::vector<Memory> memory_;
    std::vector<Group> groups_;  // of the island at hand
    std::vector<int> turning_;
    int count_ = 0;
    bool changed_ = true;
};

}  // namespace pushfactor::engine
