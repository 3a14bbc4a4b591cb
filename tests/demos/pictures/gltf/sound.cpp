#include "tests/demos/pictures/gltf/glb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

namespace pushfactor::tests {

void check_sound(const Glb& glb) {
    const Json& json = glb.json;
    CHECK(json["asset"]["version"] == "2.0");
    std::size_t end = 0;
    for (const Json& view : json["bufferViews"]) {
        CHECK(view["byteOffset"] == end);
        end += view["byteLength"].get<std::size_t>();
    }
    CHECK(json["buffers"] == Json::array({{{"byteLength", end}}}));
    CHECK(end == glb.binary.size());

    const auto check_bounds = [&](std::size_t accessor, std::size_t each) {
        const std::vector<double> numbers = glb.numbers(accessor);
        for (std::size_t part = 0; part < each; ++part) {
            double low = numbers[part], high = numbers[part];
            for (std::size_t i = part; i < numbers.size(); i += each) {
                low = std::min(low, numbers[i]);
                high = std::max(high, numbers[i]);
            }
            CHECK(static_cast<float>(json["accessors"][accessor]["min"][part].get<double>()) ==
                  static_cast<float>(low));
            CHECK(static_cast<float>(json["accessors"][accessor]["max"][part].get<double>()) ==
                  static_cast<float>(high));
        }
    };
    for (const Json& mesh : json["meshes"]) {
        for (const Json& part : mesh["primitives"]) {
            const std::size_t positions = part["attributes"]["POSITION"], normals = part["attributes"]["NORMAL"];
            check_bounds(positions, 3);
            CHECK(glb.count(positions) == glb.count(normals));
            const std::vector<double> at = glb.numbers(positions), normal = glb.numbers(normals);
            const std::vector<double> corners = glb.numbers(part["indices"]);
            CHECK(corners.size() % 3 == 0);
            CHECK(part["material"] < json["materials"].size());
            bool inside = true, unit = true, outwards = true;
            for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
                std::array<Vector3, 3> corner, up;
                for (std::size_t c = 0; c < 3; ++c) {
                    const auto index = static_cast<std::size_t>(corners[i + c]);
                    inside &= index < glb.count(positions);
                    corner[c] = Vector3(&at[3 * index]);
                    up[c] = Vector3(&normal[3 * index]);
                    unit &= std::abs(up[c].norm() - 1.0) < 1e-5;
                }
                const Vector3 area = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
                outwards &= area.dot(up[0] + up[1] + up[2]) >= -1e-9;
            }
            CHECK(inside);
            CHECK(unit);
            CHECK(outwards);
        }
    }
    // Every node once in the tree.
    std::multiset<std::size_t> placed;
    for (const Json& node : json["scenes"][0]["nodes"]) placed.insert(node.get<std::size_t>());
    for (const Json& node : json["nodes"]) {
        if (node.contains("mesh")) CHECK(node["mesh"] < json["meshes"].size());
        if (!node.contains("children")) continue;
        for (const Json& child : node["children"]) placed.insert(child.get<std::size_t>());
    }
    CHECK(placed.size() == json["nodes"].size());
    CHECK(std::set<std::size_t>(placed.begin(), placed.end()).size() == placed.size());

    if (!json.contains("animations")) return;  // nothing moves; the format forbids an empty list
    REQUIRE(json["animations"].size() == 1);
    std::set<std::pair<std::size_t, std::string>> targets;
    for (const Json& channel : json["animations"][0]["channels"]) {
        const std::size_t node = channel["target"]["node"];
        const std::string path = channel["target"]["path"];
        CHECK(node < json["nodes"].size());
        CHECK(targets.insert({node, path}).second);
        const Json& sampler = *glb.sampler(node, path);
        const std::size_t times = sampler["input"], values = sampler["output"];
        check_bounds(times, 1);
        const std::vector<double> seconds = glb.numbers(times);
        CHECK(std::adjacent_find(seconds.begin(), seconds.end(), std::greater_equal<>()) == seconds.end());
        CHECK(glb.count(times) == glb.count(values));
        const std::vector<double> numbers = glb.numbers(values);
        const bool rotation = path == "rotation";
        CHECK(json["accessors"][values]["type"] == (rotation ? "VEC4" : "VEC3"));
        const std::size_t each = rotation ? 4 : 3;
        bool unit = true, near = true, moves = false;
        for (std::size_t i = 0; i < numbers.size(); i += each) {
            for (std::size_t part = 0; part < each; ++part) moves |= numbers[i + part] != numbers[part];
            if (!rotation) continue;
            const Eigen::Vector4d q(&numbers[i]);
            unit &= std::abs(q.norm() - 1.0) < 1e-5;
            if (i > 0) near &= q.dot(Eigen::Vector4d(&numbers[i - 4])) >= 0.0;
        }
        INFO("node " << node << " " << path);
        CHECK(unit);
        CHECK(near);
        CHECK(moves);
    }
}

}  // namespace pushfactor::tests
