// The constants that decide physics: what each decides, and why it has this value. What a user sets is not here
// (`--margin`, `--slop`, `--beta`, ...), nor are bounds on rounding, the limits within a solver, and how work is
// shared; these are where they are used.
//
// Lengths are fractions of the size of a body or, of a pair, of the smaller movable one.
#pragma once

namespace pushfactor::engine::constants {

// How a body turns freely (3.2).
namespace integration {
// Largest angle of a sub-turn [rad]. The error of the energy grows with its square; in free flight that is no
// drift, but from bounce to bounce it is a random walk.
inline constexpr double largest_turn = 0.1;
}  // namespace integration

// Which points two shapes have in common, and which pairs meet within a step (section 4).
namespace collision {
// Distance at which two bodies have met: the gap up to which rows with the default slop count a point as touching.
inline constexpr double meeting_gap = 2e-6;
// By how much a corner may sink that the manifold leaves out: as the slop, what is seen of no body.
inline constexpr double unseen = 2e-3;
// Extra depth that a pair with rows may end the step with: a tenth of it makes 3 more of 2700 falls of thin bodies
// hold (tests/fuzz_scenes --thin-falls 2700) and heaps of rods and plates a sixth slower.
inline constexpr double deep = 0.02;
// The same of a pair without rows, of which nothing holds a part off or pushes it out again in this step.
inline constexpr double deep_without_rows = 0.005;
// How often contacts are added at most for bodies that the last solution of the step has thrown into something, one
// more body of a chain of collisions each time. Of 40 heaps of rods (tests/fuzz_scenes --families 40 --family rods)
// 31 hold with 6, 28 with 4 or 10: with few, pairs end deep in each other; with many, single steps take long.
inline constexpr int most_looks = 6;
// By how much the overlap along another axis has to be less before it is taken, a fraction of the smaller
// polyhedron's least width: else rounding would turn the normal of bodies at rest.
inline constexpr double axis_preference = 5e-4;
// By which the face that the axis is normal to is widened before clipping, a fraction of that width: with exactly
// aligned faces the corners of the other lie on its sides and would be clipped in one step and kept in the next.
inline constexpr double clip_tolerance = 2e-4;
// Ratio of length to width above which a manifold has a long direction; below it that direction is noise.
inline constexpr double long_ratio = 2.0;
}  // namespace collision

// Rows of contacts and joints (section 5).
namespace rows {
// Distance up to which a point takes over the force of one of the step before, if none has its feature.
inline constexpr double same_point = 0.02;
// Gap above which a point is apart, and not held off by an error that the solver has left.
inline constexpr double apart = 1e-5;
// Speed from which on the direction of sliding counts, as a share of the root of size times acceleration by
// external forces; under the paper's bound, of a size per step. Slower points are held along fixed tangents.
inline constexpr double sliding = 1e-4;
// Softness of rows that close a loop, as a share of their A_jj. Modes of the loop that are softer still, where bars
// fold onto each other, count as none; a bridge of twelve planks sags by 3e-5 m.
inline constexpr double softness_in_loops = 1e-4;
// Heights by which contacts are ordered are rounded to a share of the size, because otherwise rounding errors would
// decide the order within a layer, differently after each step. In any unit: so scaled scenes keep their order.
// Neither tenths nor halves of a quantum are near the rounding threshold.
inline constexpr double quanta_a_size = 256.0, rounds_up_at = 0.54;
}  // namespace rows

// Collisions with restitution, one after the other (8.2).
namespace impacts {
// Impacts of a step at most, per body that flies.
inline constexpr int most_per_body = 100;
// Share of the speed that the impacts of a pair in a step have lost in all, below which another one counts as a
// contact: it ends the cascades of a heap, also those in which light bodies between heavy ones lose little each
// time, and nothing of elastic bodies. What is fast and counts as a contact may pass: of 1200 sandwiches (fault
// scenes test) none does with a hundredth, one with a fiftieth, 47 with a tenth.
inline constexpr double share_of_lost = 0.01;
// What a body has to be moved by to hit anything else.
inline constexpr double noticed = 1e-3;
// Way of the points of a pair that separates after which it is looked at again.
inline constexpr double unseen_way = 1e-2;
// Largest turn of a body along one motion in which impacts are searched [rad].
inline constexpr double steady_turn = 0.3;
// How often a pair that touches without an impact is looked at in a step.
inline constexpr double looks_per_step = 16.0;
}  // namespace impacts

// Small steps (8.1, n times).
namespace small_steps {
// (omega h)^2 of a body at rest on a closed row, omega being the angular frequency at which it would bounce if
// nothing damped it. An explicit spring is stable below 4; the larger, the less heaps are compressed. Of 0.7 and
// 1.7, walls and houses of cards gain energy with the latter.
inline constexpr double stiffness = 0.7;
// Sweeps of the displacement that takes overlaps apart.
inline constexpr int push_sweeps = 4;
// Change of a row's velocity from which on sweeps go on, over the speed that a small step's external forces cause;
// no whole number, so that rounding does not decide for what falls.
inline constexpr double hit = 12.5;
// The same over the largest change of the first sweep, for impacts that are faster still.
inline constexpr double small_share = 1e-3;
// Sweeps of a solve at most. A pyramid hit at 20 m/s, whose bricks are thrown up by 0.2 m/s if it is solved, throws
// them up by 5 m/s with one sweep, by 0.9 with 25, and by 0.3 with 100, which cost four times as much in that step.
inline constexpr int most_sweeps = 100;
}  // namespace small_steps

// How an island is solved in a step, and in how many small steps (step/choice.h).
namespace choice {
// A body moves if it is faster than the speed that so many steps of its external force give it: no whole number,
// which a body that has just begun to fall would have but for rounding.
inline constexpr double steps_of_force = 1.5;
// Small steps at least. Were there fewer of what moves than of what stands, the stiffness of contacts would change
// in the middle of each sway of a column, which drives it like a swing. With 10, twenty thin plates that fall by a
// millimetre tremble for ever, by up to 0.16 m/s; with 16 a step of 1000 falling cubes takes a seventh longer.
inline constexpr int fewest_steps = 12;
// The more, the smaller a body and the larger its force: a body at rest is compressed by at most so much of its
// radius of gyration; up to a limit.
inline constexpr double compressed = 0.01, most_steps = 1000.0;
// What a direct solution is worth where an island stands, in sweeps over the rows: those of twice as many small
// steps, of two solves each, times the ratio of its masses, because sweeps need so many more. Where it has no
// forces yet or nearly the right ones, the solution lasts, and is worth those of some thirty usual steps.
inline constexpr double sweeps_of_a_step = 4.0, sweeps_that_last = 800.0;
// Limit on its multiply-adds for so many bodies or fewer, in proportion for more: the first step of a wall of 400
// bricks takes some 0.15 s, none after it more than some 30 ms. With a tenth, a heavy ball shakes the cubes on
// which it has fallen until they are scattered. Had the limit no proportion, towers of 800 planks would sag by 3
// cm; with two fifths, a pyramid of 3240 cubes by 2.5 cm in 1000 steps.
inline constexpr double most_work = 2e8, bodies_of_limits = 200.0;
// Bodies of a stack of five and one more: so few that stand are worth what so many are, and so is any island whose
// masses are so unequal that load does not pass in small steps: a tower of twenty cubes on which a heavy one falls.
inline constexpr int few = 6;
// What it is always worth per body: of these; of islands that take no small steps; of loops of joints, whose forces
// sweeps do not find; of mechanisms that touch nothing. And of bars with contacts. With half of it stacks of five
// cubes that are thrown together end 1 mm and more from where their twins of eight points do, instead of 0.2 mm.
inline constexpr double of_a_body = 4e5, of_a_body_on_bars = 2e4;
// Factorisations that it needs: where the solution lasts, or nothing has bounds, one to find the forces and one to
// see that no row changes its state; else most islands take so many. One that lasts may take more, as it is not
// repeated: walls of bricks that touch their neighbours take 24.
inline constexpr double when_near = 2.0, from_afar = 10.0, at_worst = 25.0;
// Residuals, and speeds of bodies, up to which forces are nearly right and stay so, and residuals up to which they
// are as good as right, over the speed that the external forces of a step cause.
inline constexpr double near = 1e-3, good = 1e-6;
// Share of the lower tolerance up to which a guess leaves what stands where it is. A body goes on with what moves
// it if it is as fast as that share of the residual.
inline constexpr double at_rest = 0.01, as_fast = 0.1;
}  // namespace choice

// Pushes of bars and joints that are not worth a second column (constraints/held_pairs.h).
namespace held {
// Over the speed that the external forces give in a step: what carries load in small steps is compressed by as
// much.
inline constexpr double share_of_forces = 0.02;
}  // namespace held

// When a body rests (step/rest.h).
namespace rest {
inline constexpr double time = 0.5;    // s, for which it has to be still
inline constexpr double bound = 1e-5;  // by which it may move in that time
// That the net force on it may be, and its moment over its size. A pendulum off its lowest point never rests.
inline constexpr double share_of_weight = 1e-6;
}  // namespace rest

}  // namespace pushfactor::engine::constants
