// The distance constraint, paper section 5.2: point p_a of body a and point p_b of body b stay at distance l.
// With l = 0 it is a ball joint: the points coincide.
//
//   c = |p_ab| - l,   j_c = [-n, -r_a x n, n, r_b x n] with n = p_ab / |p_ab|,   v = -beta (|p_ab| - l) / dt
//
// and with l = 0 three rows, along the world's x, y and z:
//
//   c_k = p_ab . e_k,   j_c = [-e_k, -r_a x e_k, e_k, r_b x e_k],   v_k = -beta c_k / dt
//
// without the couple by which force and reaction of an open joint would turn the pair (held_pairs.h); |p_ab|
// closes at the same rate, because turning moves p_ab only sideways.
//
// A spring of stiffness k and damping c pulls with k (|p_ab| - l) + c d|p_ab|/dt, both at the end of the step
// (implicit Euler): a soft row with
//
//   v = -k (|p_ab| - l) / (k dt + c),   softness s = 1 / (dt (k dt + c))
//
// which holds for any step and stiffness, and damps a free oscillation of angular frequency w by itself, with the
// damping ratio w dt / 2.
//
// Symbols: p_ab = p_b - p_a [m]; r_i = p_i - x_i offset from the centre of mass [m]; l length [m]; v push factor
// [m/s]; lambda force along n [N], positive pushes the points apart. World frame.
//
// Deviations: 5.2.2 and 5.2.3 print v without the minus, which drives the points apart at a growing rate. 5.2.1
// uses the unnormalised p_ab, so its v is in m^2/s while 5.2.3 gives m/s; with the unit vector both are in m/s,
// as section 9.2 requires. If p_ab is zero and l is not, n is the world's y axis. With l = 0 the direction of
// p_ab is rounding noise and one row constrains one direction of three, so there are three rows. 5.1 allows
// rows that "only act in one direction" and rows with a force limit: ropes, struts and bars that yield.
#pragma once

#include "engine/constraints/held_pairs.h"

#include <optional>
#include <vector>

namespace pushfactor::engine {

struct Spring {
    double stiffness = 0.0;  // k, N/m, >= 0
    double damping = 0.0;    // c, N s/m, >= 0; one of both above 0
};

struct Distance {
    enum class Acts {
        both,    // a bar
        pulls,   // a rope: at most l apart
        pushes,  // a strut: at least l apart
    };

    int body_a = 0;  // indices into the bodies of the world; a static body represents the world itself
    int body_b = 0;
    Vector3 point_a = Vector3::Zero();  // m, body frame, from the centre of mass
    Vector3 point_b = Vector3::Zero();
    double length = 1.0;  // m, >= 0; 0 is a ball joint, which acts both ways and without limit
    Acts acts = Acts::both;
    double max_force = infinity;     // N, > 0
    std::optional<Spring> spring{};  // without: rigid. Not for a ball joint; acts both ways
};

inline bool is_ball_joint(const Distance& distance) {
    return distance.length == 0.0;
}

inline std::size_t row_count(const Distance& distance) {
    return is_ball_joint(distance) ? 3 : 1;
}

// Forces are along the bar, or along the world's x, y and z for a ball joint.
class DistanceConstraints : public HeldPairs<Distance, 3> {
  public:
    DistanceConstraints(std::vector<Distance> distances, const Correction& correction, bool cached);

    void append_rows_of(std::size_t index, const BodyPair& bodies, double dt, RowList& rows) const override;
    bool turns_unseen(int body) const override;
    double stored_energy(std::span<const Body> bodies) const override;

    std::span<const Distance> distances() const { return items_; }

  private:
    void append_bar(std::size_t index, const BodyPair& bodies, double dt, RowList& rows) const;
    void append_joint(std::size_t index, const BodyPair& bodies, double dt, RowList& rows) const;
};

using DistanceForce = DistanceConstraints::Force;

}  // namespace pushfactor::engine
