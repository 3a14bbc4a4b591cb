// Impacts between the colliders of a ContactConstraints.
#pragma once

#include "engine/constraints/contact_constraints.h"
#include "engine/impacts/impact_solver.h"
#include "engine/impacts/impacts.h"
#include "engine/impacts/next_impact.h"

#include <set>
#include <span>
#include <vector>

namespace pushfactor::engine {

class ContactImpacts : public Impacts {
  public:
    // `contacts` must outlive it.
    explicit ContactImpacts(ContactConstraints& contacts) : contacts_(contacts) {}

    bool fly(const StepStart& step, const RowSources& sources, std::span<const ConstraintRow> rows,
             const Awake& awake) override;

  private:
    // Two colliders that may hit each other.
    struct Meeting {
        collision::Touch touch;  // without points
        ImpactLimits limits;
        double time;        // s, of their next impact; never: none
        double left = 1.0;  // of a speed of approach, after as many rebounds as they have had in this step
    };

    // A time of a meeting, for the order in which they come.
    struct Next {
        double time;
        collision::Pair pair;
        int meeting;

        friend bool operator<(const Next& a, const Next& b) {
            return a.time != b.time ? a.time > b.time : b.pair < a.pair;
        }
    };

    void find_about_to_rebound();
    void measure_colliders();
    ImpactLimits limits_of(const collision::Touch& touch) const;
    void begin(std::span<const ConstraintRow> rows);
    void find_what_holds(std::span<const ConstraintRow> rows);
    int group_of(int body);
    Flight& fly_body(int body);
    Flier flier(int collider);
    void set_off(double time);
    void foresee(int meeting, double from);
    int earliest();
    int add_to_problem(int body, double time);
    void add_what_holds(const collision::Touch& touch, double time, std::span<const ConstraintRow> rows);
    const ConstraintRow& row_at(int row, double time, std::span<const ConstraintRow> rows);
    void strike(int meeting, std::span<const ConstraintRow> rows);

    ContactConstraints& contacts_;
    ImpactSolver solver_;
    ImpactProblem problem_;
    collision::Manifold manifold_;

    std::vector<std::vector<int>> colliders_of_;  // by body
    std::vector<double> radii_, turning_;         // m, by collider, see Flier

    // Of the current step.
    StepStart step_{};
    RowSources sources_{};
    const Awake* awake_ = nullptr;
    std::vector<int> flying_;    // bodies, by flight
    std::vector<double> reach_;  // m, by body, from its start: up to there its meetings are known; < 0: none are
    std::vector<Meeting> meetings_;
    std::vector<std::vector<int>> meetings_of_;  // by flight
    std::vector<Next> next_;                     // heap, with entries that are no longer valid
    std::set<collision::Pair> known_;            // of meetings_
    std::vector<int> changed_;                   // bodies that have got other velocities
    // Of the rows:
    std::vector<int> holding_;      // ascending
    std::vector<int> parent_;       // by body, union-find over rows that hold
    std::vector<Vector6> by_rows_;  // by body, N and N m, of joints
    std::vector<char> lies_;        // by body, whether a contact has carried it or something on it

    RowList item_;         // rows of one bar or joint, where its bodies are
    int item_begin_ = -1;  // its first row of the step; -1: none

    std::vector<int> number_;   // by body, in the problem; -1: none
    std::vector<int> members_;  // bodies of the problem, by number
};

}  // namespace pushfactor::engine
