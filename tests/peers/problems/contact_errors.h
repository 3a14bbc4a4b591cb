// How wrong impulses of a frictional contact problem are, in several measures.
#pragma once

#include "tests/peers/problems/contact_problem.h"

namespace pushfactor::tests::problems {

struct ContactErrors {
    // That of Siconos (fc3d_compute_error): |r - P_K(r - (u + mu |u_T| n))|_2 over all contacts, divided by
    // max(|q|, |r|, |u|), K the cone of Coulomb. For comparison with the literature. It adds impulses and
    // velocities: it has no unit and depends on those of the problem; where W is small, large velocities hide in
    // it.
    double siconos = 0.0;
    // Largest over the contacts of L |r - P_K(r - (u + mu |u_T| n) / L)|, L the largest eigenvalue of the contact's
    // block of W [m/s]. Blind to the order in which contacts are wrong together.
    double natural_map = 0.0;
    double penetration_rate = 0.0;  // m/s, largest -u_n
    double cone_violation = 0.0;    // N s, largest of |r_T| - mu r_n and of -r_n
    double wrong_friction = 0.0;    // m/s, largest sliding that friction does not oppose: |u_T| at r_T inside the
                                    // disc, and the part of u_T that is not against r_T on its edge
    double dissipation = 0.0;       // N m, -sum r . u: energy that the contacts take out; negative if they add
};

// `impulses` are r, three per contact [N s].
ContactErrors contact_errors(const LocalProblem& problem, const engine::VectorX& impulses);

}  // namespace pushfactor::tests::problems
