// Whether two colliders meet within a step: the one rule for every pair whose paths could cross.
//
// The free motions of the step decide, with its external forces and without what constraints will do. A pair
//   touches  if it has met already: the contact is that of the start of the step (section 4);
//   meets    at a time within the step: the contact has the normal and the points of that moment. The gap of such a
//            point is the rest of its path along the normal, so its row aims at -gap/dt like that of every
//            separated point, and the bodies end the step touching;
//   is near  if it does not meet, but ends the step in the margin: the contact is that of the end, or that of the
//            start if nothing closes the gap. Its rows do nothing unless another body pushes it there;
//   passes   if it has come and gone: no contact, however close or fast.
// Of a pair with a body that has been followed from impact to impact (impacts.h) the contact is that of the start
// or, if they touch only then, that of the end: the straight way between them is not the one that it took.
//
// Points farther than the margin take part only if the pair touches or meets, and the rest of the step closes them.
// A margin as wide as the path would instead stop bodies at faces that they pass ("ghost collisions").
//
// What one body does to another is not free motion: seams.h has the contacts that others prevent, and
// continuous_collision.h those that the solution of a step brings about.
//
// Not from the paper, which has no continuous collision detection.
#pragma once

#include "engine/collision/detector.h"

namespace pushfactor::engine::collision {

// Writes the contact of the colliders of `touch` into `manifold`, and the time until they meet [s, 0 if they touch
// or are near] into the touch. Returns false if there is none.
bool meet(const StepScene& scene, Touch& touch, Manifold& manifold);

// Writes the contact that they have at the end of the step into `manifold`, with the gaps that its points have for
// rows of the whole step, wound back to its start: below zero where they end deep (Touch::ends_deep). Returns false
// if there is none.
bool contact_at_end(const StepScene& scene, const Touch& touch, Manifold& manifold);

// Gap along the normal of the touch at the end of the step [m]: the shapes are at least as far apart, or overlap by
// no more.
double gap_at_end(const StepScene& scene, const Touch& touch);

// Speed at which a approaches b at `point` [m] along `normal` (unit length, from a to b), with their centres
// there [m]; m/s.
double closing_speed(const Motion& a, const Vector3& centre_a, const Motion& b, const Vector3& centre_b,
                     const Vector3& point, const Vector3& normal);

}  // namespace pushfactor::engine::collision
