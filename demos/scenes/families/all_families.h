// The families by source file.
#pragma once

#include "demos/scenes/families/family.h"

namespace pushfactor::demos::families {

extern const Family cubes, boxes, mixed, rods, plates, funnel;  // piles.cpp: dropped bodies
extern const Family round_tower, square_tower, crossed;         // towers.cpp: planks
extern const Family wall, wall_hit;                             // walls.cpp: bricks
extern const Family pyramid, stacks, ball_on_cubes;             // blocks.cpp: structures of cubes and blocks
extern const Family overhang, seesaw, taken_out;         // balances.cpp: what stands or falls by its centre of mass
extern const Family card_house, dominoes, leaning_slab;  // cards.cpp: thin bodies that stand or lean
extern const Family cut_column, arch;                    // wedges.cpp: polyhedra with faces that slope
extern const Family net;                                 // nets.cpp: bars that hang

}  // namespace pushfactor::demos::families
