// A reader of .glb files, written after the specification of glTF 2.0 alone.
#pragma once

#include "demos/base/text/json.h"
#include "engine/base/math.h"
#include "tests/catch.h"

#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace pushfactor::tests {

using demos::Json;
using engine::Quaternion;
using engine::Vector3;

template <typename Number>
Number number_at(const std::string& bytes, std::size_t offset) {
    Number number{};
    REQUIRE(offset + sizeof number <= bytes.size());
    std::memcpy(&number, bytes.data() + offset, sizeof number);
    return number;
}

// A .glb file, taken apart as the specification says (sections 4.4 and 3.6.2).
struct Glb {
    Json json;
    std::string binary;

    explicit Glb(const std::string& file) {
        REQUIRE(file.size() >= 20);
        REQUIRE(file.substr(0, 4) == "glTF");
        REQUIRE(number_at<std::uint32_t>(file, 4) == 2);
        REQUIRE(number_at<std::uint32_t>(file, 8) == file.size());
        const auto length = number_at<std::uint32_t>(file, 12);
        REQUIRE(length % 4 == 0);
        REQUIRE(file.substr(16, 4) == "JSON");
        json = demos::parse_json(file.substr(20, length));
        const std::size_t at = 20 + length;
        const auto binary_length = number_at<std::uint32_t>(file, at);
        REQUIRE(binary_length % 4 == 0);
        REQUIRE(file.substr(at + 4, 4) == std::string("BIN\0", 4));
        REQUIRE(at + 8 + binary_length == file.size());
        binary = file.substr(at + 8);
    }

    std::size_t count(std::size_t accessor) const { return json["accessors"][accessor]["count"]; }

    // Numbers of an accessor, one after the other.
    std::vector<double> numbers(std::size_t accessor) const {
        const Json& described = json["accessors"][accessor];
        const Json& view = json["bufferViews"][described["bufferView"].get<std::size_t>()];
        const bool is_float = described["componentType"] == 5126;
        REQUIRE((is_float || described["componentType"] == 5123));
        const std::size_t size = is_float ? 4 : 2;
        const std::map<std::string, std::size_t> parts{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
        const std::size_t each = parts.at(described["type"]);
        const std::size_t start = described["byteOffset"].get<std::size_t>();
        CHECK(start % size == 0);
        CHECK(view["byteOffset"].get<std::size_t>() % 4 == 0);
        if (view.contains("byteStride")) CHECK(view["byteStride"] == each * size);
        REQUIRE(start + count(accessor) * each * size <= view["byteLength"].get<std::size_t>());
        std::vector<double> found;
        for (std::size_t i = 0; i < count(accessor) * each; ++i) {
            const std::size_t at = view["byteOffset"].get<std::size_t>() + start + i * size;
            found.push_back(is_float ? number_at<float>(binary, at) : number_at<std::uint16_t>(binary, at));
        }
        return found;
    }

    std::size_t node(const std::string& name) const {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < json["nodes"].size(); ++i) {
            if (json["nodes"][i]["name"] == name) found.push_back(i);
        }
        INFO(name);
        REQUIRE(found.size() == 1);
        return found.front();
    }

    // The sampler that moves a property of a node; null without.
    const Json* sampler(std::size_t node, const std::string& path) const {
        if (!json.contains("animations")) return nullptr;
        const Json& animation = json["animations"][0];
        for (const Json& channel : animation["channels"]) {
            if (channel["target"]["node"] == node && channel["target"]["path"] == path) {
                return &animation["samplers"][channel["sampler"].get<std::size_t>()];
            }
        }
        return nullptr;
    }

    // A property at a time that is that of a key, or of all keys before it [s].
    std::vector<double> value(std::size_t node, const std::string& path, double time) const {
        const Json* const moved = sampler(node, path);
        if (!moved) {
            const Json& property = json["nodes"][node];
            if (property.contains(path)) return property[path];
            return path == "rotation" ? std::vector<double>{0, 0, 0, 1} : std::vector<double>(3, path == "scale");
        }
        const std::vector<double> times = numbers((*moved)["input"]), all = numbers((*moved)["output"]);
        const std::size_t each = path == "rotation" ? 4 : 3;
        std::size_t key = 0;
        while (key + 1 < times.size() && times[key + 1] < time + 1e-5) ++key;
        return {all.begin() + static_cast<std::ptrdiff_t>(each * key),
                all.begin() + static_cast<std::ptrdiff_t>(each * (key + 1))};
    }

    Vector3 vector(std::size_t node, const std::string& path, double time) const {
        return Vector3(value(node, path, time).data());
    }
    Quaternion rotation(std::size_t node, double time) const {
        return Quaternion(value(node, "rotation", time).data());
    }
};

// Checks every part of a file that the specification wants, and every number within it.
void check_sound(const Glb& glb);

}  // namespace pushfactor::tests
