// Wavefront OBJ files.
#pragma once

#include "engine/base/math.h"

#include <filesystem>
#include <vector>

namespace pushfactor::demos {

// All vertices of the file [m]; faces, normals and materials are ignored. Throws UsageError for a file that cannot
// be read, and engine::InvalidInput with the line and the word for one whose vertices are no numbers, or that has
// none.
std::vector<engine::Vector3> read_obj_points(const std::filesystem::path& file);

}  // namespace pushfactor::demos
