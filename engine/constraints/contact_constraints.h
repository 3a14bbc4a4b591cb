// Contacts as a constraint source: colliders -> pairs -> manifolds -> rows (paper sections 4, 5.3, 5.4), and
// the cache of their forces (6.2.3).
#pragma once

#include "engine/collision/continuous_collision.h"
#include "engine/collision/detector.h"
#include "engine/collision/seams.h"
#include "engine/constraints/constraint_source.h"
#include "engine/constraints/contact_cache.h"
#include "engine/constraints/contact_order.h"
#include "engine/constraints/contact_row.h"
#include "engine/constraints/friction_row.h"

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace pushfactor::engine {

struct ContactChoices {
    Correction correction;           // how penetration is corrected (5.3.1, 8.1)
    double slop = 0.002;             // uncorrected penetration, fraction of the size, >= 0
    collision::Detection detection;  // margin, points of a manifold
    RowOrder order = RowOrder::bottom_up;
};

// A contact point of the last step and its rows, for display.
struct ContactSite {
    int body_a = 0;
    int body_b = 0;
    Vector3 position = Vector3::Zero();  // m, world frame
    Vector3 normal = Vector3::UnitY();   // unit length, from a to b
    std::size_t normal_row = 0;
    std::optional<std::size_t> friction_row{};  // the first of two
    std::array<Vector3, 2> tangents{Vector3::Zero(), Vector3::Zero()};
    bool swept = false;  // found by continuous collision: the rows act where the bodies meet within the step
};

// A contact point between bodies that rest, with the force that it had when they came to rest.
struct RestingContact {
    ContactSite site;                 // without rows
    double normal = 0.0;              // N
    Vector3 force = Vector3::Zero();  // N, with friction, on b
};

class ContactConstraints : public ConstraintSource {
  public:
    ContactConstraints(std::vector<collision::Collider> colliders, const ContactChoices& choices);

    // Without a rule there is no friction or no restitution; without a cache every step starts from zero.
    void set_friction(FrictionRule rule) { friction_ = std::move(rule); }
    void set_restitution(RestitutionRule rule) { restitution_ = rule; }
    // Without it bodies that are thrown in a step are noticed only in the next one.
    void set_continuous_collision(std::unique_ptr<collision::ContinuousCollision> part) {
        continuous_collision_ = std::move(part);
    }
    void set_cache(std::unique_ptr<ContactCache> cache) { cache_ = std::move(cache); }
    // By body, a number of what joints connect it with: contacts between bodies of one number close a loop
    // (constraint_row.h). None: no contact does.
    void set_mechanisms(std::vector<int> of_bodies) { mechanisms_ = std::move(of_bodies); }
    // Pairs that do not touch, and what is known of pairs of materials; null: none. Before the first step.
    void set_filter(std::unique_ptr<const collision::PairFilter> filter);
    void set_materials(std::unique_ptr<const collision::MaterialPairs> materials);

    void append_rows(const StepStart& step, RowList& rows) override;
    void append_unforeseen(const StepStart& step, std::span<const Vector6> forces, std::span<const char> changed,
                           RowList& rows) override;
    void remember(std::span<const Lambda> answers) override;
    bool turns_unseen(int body) const override;
    SomeBodies changed_anew(double from, double until) const override;
    SomeBodies met_by_moved(const StepStart& step) const override;
    bool can_leave_out() const override { return true; }
    void leave_out_others(std::span<const Body> bodies, const Awake& awake, std::span<const int> changed) override;

    std::span<const collision::Collider> colliders() const { return colliders_; }
    std::span<const int> colliders_of(int body) const { return colliders_of_[static_cast<std::size_t>(body)]; }
    // Null if absent.
    const FrictionRule* friction() const { return friction_ ? &friction_ : nullptr; }
    RestitutionRule restitution() const { return restitution_; }
    const collision::ContinuousCollision* continuous_collision() const { return continuous_collision_.get(); }
    const collision::PairFilter* filter() const { return filter_.get(); }
    const collision::MaterialPairs* materials() const { return materials_.get(); }
    const ContactCache* cache() const { return cache_.get(); }  // without the contacts of resting bodies
    // Overwrites `into` with the forces of all contacts, resting bodies included; empty without a cache.
    void all_forces(ContactCache& into) const;
    // Takes them back, for a state of then. Without a cache there are none to take.
    void set_forces(const ContactCache& all);

    // In the order of the rows; empty before the first step.
    std::vector<ContactSite> sites() const;
    std::vector<RestingContact> sites_at_rest(std::span<const Body> bodies) const;

    // For impacts within the step (impacts.h), after append_rows().
    std::span<const collision::Touch> touches() const { return touches_; }
    collision::BroadPhase& broad_phase() { return detector_.broad_phase(); }
    double touching_gap_of(double size) const { return touching_gap(choices_.slop * size); }  // m
    // A pair of colliders as a touch without points.
    collision::Touch touch_of(const collision::Pair& pair, std::span<const Body> bodies) const;
    // Appends per point of the touch a contact row and, with friction, its two friction rows. The bodies have the
    // velocities with which they meet. The forces of the rows stand for impulses: bounds in newtons act for the
    // step.
    void append_impact_rows(const collision::Touch& touch, const BodyPair& bodies, const StepStart& step,
                            RowList& rows) const;
    // Calls `visit(touch, point, its row of the step, the first of its two friction rows)` for each contact point;
    // the last is negative without friction.
    template <typename Visit>
    void each_contact(const Visit& visit) const {
        for (const Contact& contact : contacts_) {
            visit(*contact.touch, contact.touch->points[static_cast<std::size_t>(contact.point)],
                  contact.normal_row, contact.friction_row);
        }
    }

  private:
    // One contact point of this step, with its rows and tangents.
    struct Contact {
        // Not defaulted: a vector would zero-fill the object before its members are set.
        Contact() {}  // NOLINT(modernize-use-equals-default)

        const collision::Touch* touch;
        int point;          // within the touch
        std::size_t force;  // into forces_
        int normal_row;     // index into the rows of the step
        int friction_row;   // first of two; negative without friction (`tangents` is unset then)
        int foreign_rows;   // number of rows of other sources before these
        std::array<Vector3, 2> tangents;
    };
    struct TouchFriction;

    void append_touches(std::span<const collision::Touch> touches, ContactOrder& order, const StepStart& step,
                        std::span<const Motion> paths, RowList& rows);
    std::span<Contact> add_contacts(std::span<const collision::Touch> touches, std::span<const ContactIndex> order,
                                    int row);
    void find_motions(const StepStart& step);
    void write_rows(std::span<Contact> contacts, std::size_t begin, std::size_t end, const StepStart& step,
                    std::span<const Motion> paths, std::span<ConstraintRow> rows) const;
    bool closes_loop(const BodyPair& pair) const;
    bool has_friction(const collision::Touch& touch) const { return friction_ && touch.friction > 0.0; }
    void write_normal(const Contact& contact, const BodyPair& pair, const PairPoint& at, double dt,
                      ConstraintRow& row) const;
    void write_friction(Contact& contact, const PairPoint& at, const TouchFriction& shared,
                        std::span<ConstraintRow> rows) const;
    void wake_all(std::size_t bodies);
    collision::StepScene scene_of(const StepStart& step, const StepMotions& motions);
    TouchFriction friction_of(const collision::Touch& touch, const BodyPair& pair, const Motion& motion_a,
                              const Motion& motion_b, const StepStart& step) const;
    // Relative surface velocity of running belts [m/s]; its normal component does not affect friction.
    Vector3 belt_of(const collision::Touch& touch, const BodyPair& pair, double time) const;
    void store_forces();

    std::vector<collision::Collider> colliders_;
    ContactChoices choices_;
    bool belts_start_ = false;     // some, later than at the start
    std::vector<int> mechanisms_;  // by body, or empty
    std::unique_ptr<const collision::PairFilter> filter_;
    std::unique_ptr<const collision::MaterialPairs> materials_;
    FrictionRule friction_;
    RestitutionRule restitution_ = nullptr;
    std::unique_ptr<ContactCache> cache_;
    std::unique_ptr<collision::ContinuousCollision> continuous_collision_;
    RestingForces at_rest_;

    // Bodies and colliders whose rows are appended, and those that may have moved since the last step.
    Awake awake_bodies_, awake_colliders_;
    std::vector<int> moved_bodies_, moved_colliders_;  // or empty: the awake ones
    std::vector<std::vector<int>> colliders_of_;       // by body

    // State of the current step.
    collision::Detector detector_;
    collision::Seams seams_;
    std::span<const collision::Touch> touches_;
    Threads* threads_ = nullptr;
    std::deque<collision::Touch> unforeseen_;
    collision::PointStore kept_;  // of the touches of the step
    // By body, see StepMotions: without constraints, and as the last solution has them.
    std::vector<Motion> before_, after_, paths_, after_solved_, paths_solved_;
    std::vector<char> strayed_;          // by body; empty if none has
    std::vector<double> accelerations_;  // m/s^2, from external forces; 0 for static bodies
    ContactOrder order_, unforeseen_order_;
    std::vector<Contact> contacts_;         // in the order of their rows
    std::vector<ContactForce> forces_;      // in the order of touches_, then unforeseen_, and of their points
    std::vector<std::size_t> first_force_;  // of each current touch, into forces_
    int own_rows_ = 0;
};

}  // namespace pushfactor::engine
