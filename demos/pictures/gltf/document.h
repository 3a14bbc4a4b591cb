// A glTF 2.0 document and its binary form (.glb). Specification: Khronos, "glTF 2.0", 2021; sections below are its.
#pragma once

#include "demos/base/platform/output_file.h"
#include "demos/base/text/json.h"
#include "demos/pictures/gltf/geometry.h"
#include "demos/pictures/gltf/tracks.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos::pictures::gltf {

// A surface: sRGB, each 0..1, and how much of what is behind it it hides.
struct Paint {
    glm::vec3 colour{0.5f};
    float roughness = 0.5f;
    float opacity = 1.0f;

    std::array<float, 5> key() const { return {colour.r, colour.g, colour.b, roughness, opacity}; }
};

// What a node's animation changes, as glTF calls it.
enum class Path { translation, rotation, scale };

// Indices that members return are those of the document. A document holds its meshes; the values of channels are
// asked for when the file is written, one channel after the other.
class Document {
  public:
    // `asset` is stored as "extras" of the asset.
    explicit Document(const Json& asset);

    int add_geometry(const Geometry& geometry);
    // Equal meshes are stored once. One paint per part of the geometry.
    int mesh(int geometry, const std::string& name, const std::vector<Paint>& paints);

    // `properties` are those of a node (section 5.25), without its children. `parent`: a node, or -1.
    int add_node(const Json& properties, int parent = -1);
    // The camera that looks along the -z axis of `node` (5.12); angle in radians, lengths in m.
    void add_camera(int node, double vertical_angle, double aspect, double near, double far);
    // Light from far away along the -z axis of `node` (extension KHR_lights_punctual); lux.
    void add_sun(int node, const glm::vec3& colour, double lux);

    // Times of keys [s], ascending.
    int add_times(const Values& times);
    // `step`: values stay until the next key instead of being interpolated. Values that never change have no
    // channel: the node is there already.
    void add_channel(int node, Path path, int times, bool step, std::function<Values()> values);

    // After nodes and times were added. Throws OutputError; also for more than a .glb can hold (4.4).
    void write(OutputFile& file);

  private:
    struct Shape {
        int positions = 0, normals = 0;
        std::vector<int> parts;  // accessors
    };

    int add_accessor(int view, std::size_t offset, int component, std::size_t count, const char* type);
    int material(const Paint& paint);
    void finish_views();

    Json root_;
    std::vector<Json> accessors_, nodes_, samplers_, channels_;
    std::vector<Shape> shapes_;
    std::map<std::array<float, 5>, int> materials_;                        // by Paint::key()
    std::map<std::pair<int, std::vector<int>>, int> meshes_;               // by geometry and materials
    std::string vertices_, indices_, times_;                               // bytes
    std::size_t animation_ = 0;                                            // bytes of all channels
    std::vector<std::pair<std::size_t, std::function<Values()>>> values_;  // with their number of bytes
};

// Of floats: as few digits as read back as the same float.
Json json_of_floats(std::span<const float> numbers);
Json json_of_vector(const engine::Vector3& v);
Json json_of_quaternion(const engine::Quaternion& q);  // x, y, z, w

}  // namespace pushfactor::demos::pictures::gltf
