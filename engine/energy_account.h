// Where the energy of a run comes from. What is neither there at the start nor brought in from outside has been
// made out of nothing, and no solver's error excuses that.
//
// From outside come the work of external forces other than gravity, that of surfaces that run (belts), and the work
// of the push on overlaps that were there at the start: it moves bodies without giving them momenta (8.1), against
// gravity, and may do what removing the overlap needs, which is the contact's lasting force times the way. Overlaps
// that come later are places from which bodies have fallen; lifting those back brings nothing that was not there.
//
// Semi-implicit Euler (3.2) has its momenta half a step before its positions: what rises has the potential energy
// of a moment when its kinetic energy will have been less. A rise is therefore measured half a step back.
#pragma once

#include "engine/world.h"

#include <map>
#include <utility>

namespace pushfactor::engine {

class EnergyAccount {
  public:
    explicit EnergyAccount(const Vector3& gravity) : gravity_(gravity) {}  // m/s^2

    // The state that counts as the start.
    void open(std::span<const Body> bodies, double dt);

    // Before and after a step of `dt` [s].
    void begin(std::span<const Body> bodies);
    void end(const World& world, double dt);

    // J, above the start and what came from outside; below zero where energy went. Of the state before the last
    // step: only the rows of a step say how deep its bodies lay at its beginning.
    double gain() const { return gain_; }
    double external_work() const { return external_; }  // J, of all steps: forces other than gravity, and belts
    double push_work() const { return push_; }          // J, of all steps, what overlaps of the start needed

  private:
    // What a pair that overlapped at the start has left of that.
    struct Overlap {
        double depth = 0.0;  // m, the least so far
        double force = 0.0;  // N, of its rows together in the last step
    };
    using Bodies = std::pair<int, int>;

    double energy(std::span<const Body> bodies, double dt) const;
    double external_work_of(const World& world, double dt) const;
    void note_overlaps(const World& world);
    double work_of_removing(const World& world);

    Vector3 gravity_;
    std::vector<Body> before_;
    std::map<Bodies, Overlap> overlaps_;
    bool noted_ = false;   // whether the overlaps of the start are
    double latest_ = 0.0;  // J, energy() after the last step
    double start_ = 0.0, external_ = 0.0, push_ = 0.0, gain_ = 0.0;
};

}  // namespace pushfactor::engine
