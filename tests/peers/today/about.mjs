// What is known of each engine, for the page: how it solves contacts and what it is made for, from its documentation.
export const about = {
    Rapier: "Projected Gauss-Seidel with soft contacts, four iterations in small steps and as many without correction, as shipped; written in Rust for games and robotics, with the same results on all platforms if wanted. It parts overlaps slowly, with a limit on the speed of correction, and needs few iterations for light piles.",
    Jolt: "Sequential impulses (ten, as shipped), and after them a pass that moves bodies out of each other without giving them speed (two iterations), with a slop of 2 cm; written in C++ for a large game, for many bodies on many processors. With many iterations in short steps that pass is as exact as anything here, because a position is corrected as a position.",
    MuJoCo: "A convex problem with soft constraints, solved by Newton's method to rounding in each step; written in C++ for robots and for optimisation, with reduced coordinates. What does not move is a matter of its stiffness: where contacts are made stiff it holds any of these masses, and throws what overlaps.",
};
