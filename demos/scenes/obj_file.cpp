#include "demos/scenes/obj_file.h"

#include "engine/base/invalid_input.h"

#include <tiny_obj_loader.h>  // of double numbers, by the target that is linked

#include <algorithm>

namespace pushfactor::demos {

std::vector<engine::Vector3> read_obj_points(const std::filesystem::path& file) {
    tinyobj::ObjReader reader;
    const bool read = reader.ParseFromFile(file.string());
    std::vector<engine::Vector3> points;
    if (read) {
        const std::vector<double>& numbers = reader.GetAttrib().vertices;
        for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
            points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
        }
    }
    if (points.empty()) throw engine::InvalidInput("file", file.string(), "a Wavefront OBJ file with vertices");
    return points;
}

}  // namespace pushfactor::demos
