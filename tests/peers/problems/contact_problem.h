// Frictional contact problems in the terms of FCLib (Acary and others, "FCLIB: a collection of discrete 3D
// frictional contact problems", 2014): for each contact a normal n and two tangents t1, t2, in this order, impulses
// r [N s] and relative velocities u [m/s] with
//
//   0 <= r_n perpendicular to u_n >= 0,  |r_T| <= mu r_n,  and u_T = -k r_T with k >= 0, which is 0 unless |r_T| =
//   mu r_n
//
// Global form: M v = H r + f, u = H^T v + w. Local form: u = W r + q.
#pragma once

#include "engine/base/math.h"

#include <Eigen/SparseCore>

#include <string>
#include <variant>

namespace pushfactor::tests::problems {

using SparseMatrix = Eigen::SparseMatrix<double>;

struct GlobalProblem {
    std::string title;
    SparseMatrix mass;      // M, n x n
    SparseMatrix axes;      // H, n x 3c
    engine::VectorX force;  // f, n [N s]: M times the velocities without contacts
    engine::VectorX given;  // w, 3c [m/s]
    engine::VectorX mu;     // c

    Eigen::Index contacts() const { return mu.size(); }
};

struct LocalProblem {
    std::string title;
    SparseMatrix matrix;   // W, 3c x 3c [1/kg]
    engine::VectorX free;  // q, 3c [m/s]
    engine::VectorX mu;    // c

    Eigen::Index contacts() const { return mu.size(); }

    // Largest difference of W from its transpose, relative to its largest number. Not 0 where gyroscopic terms are
    // implicit: then no bodies and axes exist that have this W.
    double asymmetry() const;
};

using ContactProblem = std::variant<GlobalProblem, LocalProblem>;

// v = M^-1 (H r + f). Throws std::runtime_error if M is singular.
engine::VectorX velocities_of(const GlobalProblem& problem, const engine::VectorX& impulses);

// W = H^T M^-1 H, q = w + H^T M^-1 f. Throws std::runtime_error if M is singular.
LocalProblem local_form(const GlobalProblem& problem);
LocalProblem local_form(const ContactProblem& problem);

}  // namespace pushfactor::tests::problems
