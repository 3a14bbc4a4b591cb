// Wavefront OBJ files.
#pragma once

#include "engine/base/math.h"

#include <filesystem>
#include <vector>

namespace pushfactor::demos {

// All vertices of the file [m]; faces, normals and materials are ignored. Throws engine::InvalidInput for a
// file that cannot be read or has none.
std::vector<engine::Vector3> read_obj_points(const std::filesystem::path& file);

}  // namespace pushfactor::demos
