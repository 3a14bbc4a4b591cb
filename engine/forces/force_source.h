// Interface of external forces on the bodies of a world.
#pragma once

#include "engine/bodies/awake.h"
#include "engine/bodies/body.h"

#include <span>

namespace pushfactor::engine {

// The bodies of a world as seen by a force source: iterates over those that are not at rest (rest.h).
class ForcedBodies {
  public:
    ForcedBodies(std::span<Body> bodies, const Awake& awake) : bodies_(bodies), awake_(awake) {}

    struct Iterator {
        const int* awake;
        Body* bodies;
        Body& operator*() const { return bodies[*awake]; }
        Iterator& operator++() {
            ++awake;
            return *this;
        }
        bool operator==(const Iterator& other) const { return awake == other.awake; }
    };
    Iterator begin() const { return {awake_.members().data(), bodies_.data()}; }
    Iterator end() const { return {awake_.members().data() + awake_.members().size(), bodies_.data()}; }

    // By index. For a resting body returns a copy, valid until the next call, because forces on it do not count.
    Body& operator[](std::size_t body) const {
        if (awake_.has(static_cast<int>(body))) return bodies_[body];
        return at_rest_ = bodies_[body];
    }
    std::size_t size() const { return bodies_.size(); }

  private:
    std::span<Body> bodies_;
    const Awake& awake_;
    mutable Body at_rest_;
};

// Adds external forces to the bodies at the start of a step (3.1: "keeps track of all the forces applied").
class ForceSource {
  public:
    virtual ~ForceSource() = default;
    // The mean over the time from `from` to `until` [s since the start of the world], so that an impulse does not
    // depend on the step; the force at that time if they are equal.
    virtual void add_forces(const ForcedBodies& bodies, double from, double until) = 0;

    // Bodies that may get a different force in the step that begins at `until` than in the one before it, from
    // `from` [s], without having moved; they cannot rest. All of them by default.
    virtual SomeBodies pushed_anew(double /*from*/, double /*until*/) const { return {.all = true}; }

    // The acceleration [m/s^2, world frame] that the source gives to all bodies alike; zero if it does not. Rows
    // are ordered along it, from the bottom up.
    virtual Vector3 gravity() const { return Vector3::Zero(); }

    // Whether the forces of the source do not change when `body` turns about its centre (ConstraintSource has the
    // same for rows).
    virtual bool turns_unseen(int /*body*/) const { return false; }
};

}  // namespace pushfactor::engine
