// What does not change in a replay: bodies, links, planes, camera and meshes of a run.
#pragma once

#include "demos/base/text/json.h"
#include "demos/options/comparison.h"
#include "demos/pictures/camera/framing.h"
#include "demos/runs/simulation.h"

#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos::pictures::replay {

// Indices of the bodies whose poses are recorded: with mass or motion.
std::vector<std::size_t> recorded_bodies(const BuiltScene& scene);

// Length [m] that a body's errors are relative to: the radius of its bounding sphere, 1 for a plane.
double size_of(const BuiltScene& scene, std::size_t body);

// The run as the page needs it, at its start.
Json stage_of(const ComparedRun& panel, const Simulation& simulation);

// A camera as the page needs it. `start`: what it has to show to the sides if there are several panels.
Json camera_of(const View& view, std::span<const Ball> start);

// What the arrows of the page mean, by overlay, as in the pictures.
Json legend_of_arrows();

// Meshes of the polyhedra of a run, as numbered by stage_of; and those of box and square. Per mesh the numbers of
// vertices and indices (32 bits each), per vertex corner and normal (six 32-bit floats), and the indices (16 bits
// each, an even number of them). The page makes the domes of the spheres itself: they are 20 kB.
std::string polyhedra_of(const Simulation& simulation);
std::string common_meshes();

}  // namespace pushfactor::demos::pictures::replay
