// Our own engine as users run it: the program on the same scene, its trajectory read back.
#pragma once

#include "tests/peers/engine.h"

namespace pushfactor::tests::peers {

struct Program {
    std::string path;
    std::string folder;  // for its files
    std::string version;
};

// Throws std::runtime_error when the program does not start.
Program find_program(const std::string& path, const std::string& folder);

// Writes the scene of `arguments` (name and parameters, or a file) as JSON and reads it.
Scene scene_of(const Program& program, const std::string& arguments);

// Writes the scene that `family` prints for `arguments` into the folder and returns what run and scene take for it.
std::string family_file(const Program& program, const std::string& name, const std::string& arguments);

// The same of Box3D's benchmark large_pyramid with so many rows: cubes of 1 m and 100 kg that touch, in one plane.
std::string pyramid_file(const Program& program, const std::string& name, int rows);

// `bodies`: number of movable bodies; `whole_steps`: momenta belong to the time of the positions (rattle).
// Where the program stops with a non-finite state, the states from there on are NaN.
Run run_program(const Program& program, const std::string& arguments, std::size_t bodies, std::size_t steps,
                bool whole_steps);

}  // namespace pushfactor::tests::peers
