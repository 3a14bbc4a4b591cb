// Impacts of colliders within a step, in the order in which they happen.
//
// If some pair with restitution is about to meet, the bodies around it fly through the step before its rows are
// written: whenever two of them hit each other, that one impact is solved (impact_solver.h), they fly on with other
// velocities, and what they meet next is searched anew. So one body may take part in many impacts of a step, a row
// of touching balls passes a blow on from ball to ball, and none flies through another one. Impacts of a body, or
// of bodies that hold each other, at the same time are one: in turn, the first would turn the body away from the
// others.
//
// What is left for the rows of the step is what does not hit anything but is held or lies: the bodies that were hit
// enter it with their new momenta, and with the place where they end if nothing holds them.
//
// Bodies that lie on something do not fall while they fly. Impacts that are slower than ImpactLimits say are
// contacts, as everything is that rests. In a heap impacts with restitution below 1 would follow each other without
// end: what is slower than a hundredth of what the pair has lost in all its impacts of the step is a contact, too.
//
// Deviations: 8.2 adds the rebound to the push of the row, so that all impacts of a step are one (`paper` does
// that, contact_row.h).
#pragma once

#include "engine/base/index.h"
#include "engine/bodies/awake.h"
#include "engine/constraints/contact_constraints.h"
#include "engine/impacts/flight.h"
#include "engine/impacts/impact_solver.h"
#include "engine/impacts/next_impact.h"
#include "engine/step/step_rows.h"

#include <set>
#include <span>
#include <tuple>
#include <vector>

namespace pushfactor::engine {

class Impacts {
  public:
    // `contacts` must outlive it.
    explicit Impacts(ContactConstraints& contacts) : contacts_(contacts) {}

    // Lets bodies that are about to rebound fly through the step, whose rows have been appended, and those that
    // they hit. Returns whether there are any. With resting() bodies hit (not in `awake`) nothing else is valid:
    // they have to be woken first.
    bool fly(const StepStart& step, const RowSources& sources, std::span<const ConstraintRow> rows,
             const Awake& awake);

    // Of the last call:
    std::span<const int> followed() const { return followed_; }  // bodies, ascending
    const Flight& flight_of(int body) const { return flights_[at(flight_of_[at(body)])]; }
    std::span<const int> resting() const { return resting_; }
    int count() const { return count_; }                     // of impacts
    bool is_cut_short() const { return is_cut_short_; }      // there were more
    double external_work() const { return external_work_; }  // J, of belts and moved bodies

  private:
    // Two colliders that may hit each other.
    struct Meeting {
        collision::Touch touch;  // without points
        ImpactLimits limits;
        double time;  // s, of their next impact; never: none
    };

    void find_about_to_rebound();
    void measure_colliders();
    ImpactLimits limits_of(const collision::Touch& touch) const;
    void begin(std::span<const ConstraintRow> rows);
    void find_what_holds(std::span<const ConstraintRow> rows);
    double speed_along(const ConstraintRow& row, double time, std::span<const Vector6> others) const;
    void leave_out_blows(std::span<const ConstraintRow> rows);
    int group_of(int body);
    Flight& fly_body(int body);
    Flier flier(int collider);
    void set_off(double time);
    void foresee(int meeting, double from);
    void expect(int meeting, double time);
    int add_to_problem(int body, double time);
    void add_pair(int meeting, double time);
    void add_what_holds(double time, std::span<const ConstraintRow> rows);
    const ConstraintRow& row_at(int row, double time, std::span<const ConstraintRow> rows);
    void find_struck();
    void strike(std::span<const ConstraintRow> rows);

    ContactConstraints& contacts_;
    ImpactSolver solver_;
    ImpactProblem problem_;
    collision::Manifold manifold_;

    std::vector<double> radii_, turning_;  // m, by collider, see Flier

    // Of the current step.
    std::vector<Flight> flights_;
    std::vector<int> flight_of_;  // by body, -1: none yet
    std::vector<int> followed_, resting_;
    int count_ = 0;
    bool is_cut_short_ = false;
    double external_work_ = 0.0;
    StepStart step_{};
    RowSources sources_{};
    const Awake* awake_ = nullptr;
    std::vector<int> flying_;    // bodies, by flight
    std::vector<double> reach_;  // m, by body, from its start: up to there its meetings are known; < 0: none are
    std::vector<Meeting> meetings_;
    std::vector<std::vector<int>> meetings_of_;                // by flight
    std::set<std::tuple<double, collision::Pair, int>> next_;  // time, pair and number of those that meet
    std::set<collision::Pair> known_;                          // of meetings_
    std::vector<int> changed_;                                 // bodies that have got other velocities
    // Of the rows:
    std::vector<int> holding_;      // ascending
    std::vector<int> parent_;       // by body, union-find over rows that hold
    std::vector<Vector6> by_rows_;  // by body, N and N m, of joints
    std::vector<char> lies_;        // by body, whether a contact has carried it or something on it

    RowList item_;         // rows of one bar or joint, where its bodies are
    int item_begin_ = -1;  // its first row of the step; -1: none

    std::vector<int> struck_;         // meetings of the problem
    std::vector<int> struck_groups_;  // of their bodies
    std::vector<int> number_;         // by body, in the problem; -1: none
    std::vector<int> members_;        // bodies of the problem, by number
};

}  // namespace pushfactor::engine
