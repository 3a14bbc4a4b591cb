// The polyhedra of a scene file: points, or the vertices of a Wavefront OBJ file.
#include "demos/base/text/errors.h"
#include "demos/base/text/input.h"
#include "demos/base/text/numbers.h"
#include "demos/scenes/convex_hull.h"
#include "demos/scenes/reading/parts.h"

#include <fmt/format.h>

#include <array>
#include <sstream>

namespace pushfactor::demos {

namespace {

using engine::Vector3;

std::vector<Vector3> read_points(const JsonReader& json) {
    std::vector<Vector3> points;
    std::map<std::array<double, 3>, std::size_t> known;
    for (const JsonReader& element : json.elements()) {
        const Vector3 point = element.vector();
        const auto [at, is_new] = known.emplace(std::array{point.x(), point.y(), point.z()}, points.size());
        if (!is_new) element.refuse(fmt::format("another point than number {}", at->second));
        points.push_back(point);
    }
    return points;
}

Vector3 vertex_of(std::istringstream& words, const std::string& where) {
    Vector3 point;
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

// All vertices [m]; faces, normals and materials are ignored.
std::vector<Vector3> read_obj_points(const std::filesystem::path& file) {
    std::istringstream lines(read_input(file, file.string()));
    std::vector<Vector3> points;
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

std::vector<Vector3> read_obj(const JsonReader& json, const std::filesystem::path& folder) {
    std::string fault;
    try {
        return read_obj_points(folder / json.string());
    } catch (const engine::InvalidInput& problem) {
        fault = problem.what();
    } catch (const UsageError& problem) {
        fault = problem.what();
    }
    json.refuse("a Wavefront OBJ file with vertices, by its path from the folder of this file; " + fault);
}

}  // namespace

FramedPolyhedron read_polyhedron(const JsonReader& body, Polyhedra& polyhedra) {
    if (body.has("obj_file") && body.has("points_m"))
        body.at("points_m").refuse("left out where obj_file is given");
    const JsonReader source = body.at(body.has("obj_file") ? "obj_file" : "points_m");
    const std::vector<Vector3> points =
        body.has("obj_file") ? read_obj(source, polyhedra.folder) : read_points(source);
    std::vector<double> key;
    for (const Vector3& point : points) key.insert(key.end(), point.begin(), point.end());
    const auto known = polyhedra.by_points.find(key);
    if (known != polyhedra.by_points.end()) return known->second;
    try {
        return polyhedra.by_points[key] = make_polyhedron(points);
    } catch (const NoPolyhedron& found) {
        source.refuse(fmt::format("{}, and these are {}", found.allowed, found.found));
    }
}

}  // namespace pushfactor::demos
