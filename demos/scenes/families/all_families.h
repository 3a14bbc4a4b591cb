// The families, by what they are made of.
#pragma once

#include "demos/scenes/families/family.h"

namespace pushfactor::demos::families {

// piles.cpp: what is dropped
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

// blocks.cpp: cubes and blocks built up
Family pyramid();
Family stacks();
Family ball_on_cubes();
Family overhang();

// cards.cpp: what is thin and stands
Family card_house();
Family dominoes();
Family leaning_slab();

}  // namespace pushfactor::demos::families
