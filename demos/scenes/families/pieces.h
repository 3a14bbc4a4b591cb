// The families by source file, and building blocks of their members. The ground is the plane y = 0.
#pragma once

#include "demos/scenes/families/family.h"
#include "demos/scenes/random.h"
#include "demos/scenes/scene_description.h"

#include <string>
#include <string_view>

namespace pushfactor::demos::families {

extern const Family cubes, boxes, mixed, rods, plates, funnel;      // piles.cpp: dropped bodies
extern const Family round_tower, square_tower, crossed, taken_out;  // towers.cpp: planks
extern const Family wall, wall_hit;                                 // walls.cpp: bricks
extern const Family pyramid, stacks, ball_on_cubes;                 // blocks.cpp: structures of cubes and blocks
extern const Family overhang, seesaw;                    // balances.cpp: what stands or falls by its centre of mass
extern const Family card_house, dominoes, leaning_slab;  // cards.cpp: thin bodies that stand or lean
extern const Family cut_column, arch;                    // wedges.cpp: polyhedra with faces that slope
extern const Family net;                                 // nets.cpp: bars that hang

constexpr double gravity = 10.0;  // m/s^2

// The parameter "friction", between `low` and `high`.
FamilyParameter friction_of(double low, double high);

// The parameters "inside" and "beyond" of a family whose members stand within a limit: on which side of it a member
// is, and by which share of it.
FamilyParameter inside_of(std::string_view help);
FamilyParameter beyond_of(double low, double high, std::string_view help);
// What such a member has of its limit, where standing takes less than that, or more.
double less_than_limit(const ParameterValues& values);
double more_than_limit(const ParameterValues& values);
// A member that stands.
Prospect standing(SceneDescription scene);

// A member that comes to rest, after the time for a heap to settle, twice the time to fall from `height` [m], and
// the sliding time of a body with the speed of that fall and the `speed` [m/s] at which it was thrown.
Prospect comes_to_rest(const ParameterValues& values, SceneDescription scene, double height, double speed = 0.0);

// Within its limit the member stands, else these bodies leave by the time `rest_by` [s].
Prospect ends_by_limit(const ParameterValues& values, SceneDescription scene, Ends outside, double rest_by,
                       const std::string& leaving);

// An empty scene with its ground, which has this friction, or the one that was drawn.
SceneDescription on_ground(double friction);
SceneDescription on_ground(const ParameterValues& values);

// A body with the friction of the ground.
BodyDescription& add_body(SceneDescription& scene, const std::string& name, const BodyShape& shape, double mass,
                          const engine::Vector3& position);

// Turned by `angle` [rad] about the vertical, and about the z axis.
engine::Quaternion turned(double angle);
engine::Quaternion inclined(double angle);

using scenes::random_orientation;

// Sets a camera with all movable bodies in the picture.
void look_at_all(SceneDescription& scene);

}  // namespace pushfactor::demos::families
