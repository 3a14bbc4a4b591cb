#include "demos/scenes/obj_file.h"

#include "demos/text/input.h"
#include "demos/text/numbers.h"
#include "engine/base/invalid_input.h"

#include <fmt/format.h>

#include <sstream>

namespace pushfactor::demos {

namespace {

engine::Vector3 vertex_of(std::istringstream& words, const std::string& where) {
    engine::Vector3 point;
    for (int axis = 0; axis < 3; ++axis) {
        std::string word;
        words >> word;
        const auto number = parse_number(word);
        if (!number) {
            throw engine::InvalidInput(where, word.empty() ? "a vertex with too few words" : "\"" + word + "\"",
                                       "a vertex of three numbers with decimal points");
        }
        point[axis] = *number;
    }
    // A weight or a colour may follow.
    for (std::string word; words >> word;) {
        if (!parse_number(word)) throw engine::InvalidInput(where, "\"" + word + "\"", "a number");
    }
    return point;
}

}  // namespace

std::vector<engine::Vector3> read_obj_points(const std::filesystem::path& file) {
    std::istringstream lines(read_input(file, file.string()));
    std::vector<engine::Vector3> points;
    int number = 1;
    for (std::string line; std::getline(lines, line); ++number) {
        std::istringstream words(line.substr(0, line.find('#')));
        std::string keyword;
        if (words >> keyword && keyword == "v") {
            points.push_back(vertex_of(words, fmt::format("{}, line {}", file.string(), number)));
        }
    }
    if (points.empty()) throw engine::InvalidInput("file", file.string(), "a Wavefront OBJ file with vertices");
    return points;
}

}  // namespace pushfactor::demos
