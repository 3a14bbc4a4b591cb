// The families by source file.
#pragma once

#include "demos/scenes/families/family.h"

namespace pushfactor::demos::families {

// piles.cpp: dropped bodies
Family cubes();
Family boxes();
Family mixed();
Family rods();
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
Family overhang();

// cards.cpp: thin bodies that stand or lean
Family card_house();
Family dominoes();
Family leaning_slab();

}  // namespace pushfactor::demos::families
