// The families by source file.
#pragma once

#include "demos/scenes/families/family.h"

namespace pushfactor::demos::families {

// piles.cpp: dropped bodies
Family cubes();
Family boxes();
Family mixed();
Family rods();
Family plates();
Family funnel();

// towers.cpp: planks
Family round_tower();
Family square_tower();
Family crossed();

// walls.cpp: bricks
Family wall();
Family wall_hit();

// blocks.cpp: structures of cubes and blocks
Family pyramid();
Family stacks();
Family ball_on_cubes();

// balances.cpp: what stands or falls by its centre of mass
Family overhang();
Family seesaw();
Family taken_out();

// cards.cpp: thin bodies that stand or lean
Family card_house();
Family dominoes();
Family leaning_slab();

// wedges.cpp: polyhedra with faces that slope
Family cut_column();
Family arch();

// nets.cpp: bars that hang
Family net();

}  // namespace pushfactor::demos::families
