// Energy balance of a run. Energy that was neither there at the start nor added from outside is an error of the
// simulation, and no solver error excuses it.
//
// Added from outside: work of external forces other than gravity, of running belts, motors and moved bodies, and of
// the push on overlaps of the start. The push moves bodies without giving them momenta (8.1), against gravity, and
// is credited with the work that removing the overlap needs, the contact's lasting force times the distance. Later
// overlaps are positions from which bodies have fallen; lifting those back adds nothing.
//
// Semi-implicit Euler (3.2) has its momenta half a step before its positions: a rising body has the potential
// energy of a time at which its kinetic energy is already lower. A rise is therefore measured half a step back.
//
// The force of a moved body acts at the beginning of the step, between its velocities in the last step and in this
// one: its work is that at the mean of both.
#pragma once

#include "engine/world.h"

#include <utility>
#include <vector>

namespace pushfactor::engine {

class EnergyAccount {
  public:
    explicit EnergyAccount(const Vector3& gravity) : gravity_(gravity) {}  // m/s^2

    // Sets the state that counts as the start; `stored` [J] is World::stored_energy().
    void open(std::span<const Body> bodies, double dt, double stored = 0.0);

    // To be called before and after a step of `dt` [s].
    void begin(std::span<const Body> bodies);
    void end(const World& world, double dt);

    // J, in excess of the start and the external work; negative for losses. For the state before the last step,
    // because only the rows of a step tell how deep its bodies were at its beginning.
    double gain() const { return gain_; }
    // J, of all steps: forces other than gravity, belts, motors, moved bodies.
    double external_work() const { return external_; }

  private:
    using Bodies = std::pair<int, int>;
    // Remaining overlap of a pair that overlapped at the start.
    struct Overlap {
        Bodies bodies;
        double depth = 0.0;    // m, smallest so far
        double force = 0.0;    // N, sum over its rows in the last step
        bool is_seen = false;  // in this step: its depth and force there
        double seen_depth = 0.0, seen_force = 0.0;
    };

    double energy(std::span<const Body> bodies, double dt) const;
    double external_work_of(const World& world, double dt) const;
    double work_of_moved(const World& world) const;
    void note_overlaps(const World& world);
    double work_of_removing(const World& world);

    Vector3 gravity_;
    std::vector<Body> before_;
    std::vector<Overlap> overlaps_;  // ascending
    bool noted_ = false;             // overlaps of the start are recorded
    double latest_ = 0.0;            // J, energy() after the last step
    double start_ = 0.0, external_ = 0.0, gain_ = 0.0;
    double push_ = 0.0;  // J, work of all steps for removing overlaps of the start
};

}  // namespace pushfactor::engine
