#include "demos/pictures/gltf/document.h"

#include "demos/base/platform/version.h"
#include "demos/base/text/errors.h"
#include "engine/base/index.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace pushfactor::demos::pictures::gltf {

namespace {

// Numbers that glTF has from OpenGL.
constexpr int unsigned_short = 5123, floating = 5126;
constexpr int array_buffer = 34962, element_array_buffer = 34963;

// Buffer views, in the order of the binary data.
constexpr int vertex_view = 0, index_view = 1, time_view = 2, animation_view = 3;

// Little-endian, as glTF wants it and as all machines that we build for have it.
template <typename Number>
void append(std::string& bytes, const Number& number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void pad(std::string& bytes, char with) {
    while (bytes.size() % 4 != 0) bytes += with;
}

double linear(float srgb) {
    return srgb <= 0.04045f ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

// Floats print as the shortest text that reads back as the same float, not as the double that they are.
double shortest(float value) {
    return std::stod(fmt::format("{}", value));
}

std::string name_of(const Paint& paint) {
    std::string name = fmt::format("#{:06x}", number_of({"", paint.colour.r, paint.colour.g, paint.colour.b}));
    for (const Colour& colour : palette) {
        if (to_glm(colour) == paint.colour) name = colour.name;
    }
    return paint.opacity < 1.0f ? name + ", translucent" : name;
}

const char* name_of(Path path) {
    return path == Path::translation ? "translation" : path == Path::rotation ? "rotation" : "scale";
}

}  // namespace

Json json_of_floats(std::span<const float> numbers) {
    Json list = Json::array();
    for (const float number : numbers) list.push_back(shortest(number));
    return list;
}

Json json_of_vector(const engine::Vector3& v) {
    const Eigen::Vector3f floats = v.cast<float>();
    return json_of_floats({floats.data(), 3});
}

Json json_of_quaternion(const engine::Quaternion& q) {
    const Eigen::Vector4f floats = q.coeffs().cast<float>();
    return json_of_floats({floats.data(), 4});
}

Document::Document(const Json& asset) {
    root_["asset"] = {{"version", "2.0"}, {"generator", "pushfactor " + version_text()}, {"extras", asset}};
}

int Document::add_accessor(int view, std::size_t offset, int component, std::size_t count, const char* type) {
    accessors_.push_back({{"bufferView", view},
                          {"byteOffset", offset},
                          {"componentType", component},
                          {"count", count},
                          {"type", type}});
    return static_cast<int>(accessors_.size()) - 1;
}

int Document::add_geometry(const Geometry& geometry) {
    Shape shape;
    const std::size_t count = geometry.positions.size();
    shape.positions = add_accessor(vertex_view, vertices_.size(), floating, count, "VEC3");
    Eigen::AlignedBox3d box;
    for (const glm::vec3& corner : geometry.positions) {
        append(vertices_, corner);
        box.extend(to_eigen(corner));
    }
    accessors_.back()["min"] = json_of_vector(box.min());
    accessors_.back()["max"] = json_of_vector(box.max());
    shape.normals = add_accessor(vertex_view, vertices_.size(), floating, count, "VEC3");
    for (const glm::vec3& normal : geometry.normals) append(vertices_, normal);
    for (const std::vector<std::uint16_t>& part : geometry.parts) {
        shape.parts.push_back(add_accessor(index_view, indices_.size(), unsigned_short, part.size(), "SCALAR"));
        for (const std::uint16_t index : part) append(indices_, index);
        pad(indices_, '\0');
    }
    shapes_.push_back(std::move(shape));
    return static_cast<int>(shapes_.size()) - 1;
}

int Document::material(const Paint& paint) {
    const auto [known, is_new] = materials_.try_emplace(paint.key(), static_cast<int>(materials_.size()));
    if (!is_new) return known->second;
    const glm::vec3& colour = paint.colour;
    Json made;
    made["name"] = name_of(paint);
    made["pbrMetallicRoughness"] = {
        {"baseColorFactor", {linear(colour.r), linear(colour.g), linear(colour.b), shortest(paint.opacity)}},
        {"metallicFactor", 0},
        {"roughnessFactor", shortest(paint.roughness)}};
    if (paint.opacity < 1.0f) made["alphaMode"] = "BLEND";
    root_["materials"].push_back(std::move(made));
    return known->second;
}

int Document::mesh(int geometry, const std::string& name, const std::vector<Paint>& paints) {
    std::vector<int> materials;
    for (const Paint& paint : paints) materials.push_back(material(paint));
    const auto [known, is_new] = meshes_.try_emplace({geometry, materials}, static_cast<int>(meshes_.size()));
    if (!is_new) return known->second;
    const Shape& shape = shapes_[engine::at(geometry)];
    Json parts = Json::array();
    for (std::size_t i = 0; i < shape.parts.size(); ++i) {
        parts.push_back({{"attributes", {{"POSITION", shape.positions}, {"NORMAL", shape.normals}}},
                         {"indices", shape.parts[i]},
                         {"material", materials[i]}});
    }
    root_["meshes"].push_back({{"name", name}, {"primitives", std::move(parts)}});
    return known->second;
}

int Document::add_node(const Json& properties, int parent) {
    const int node = static_cast<int>(nodes_.size());
    nodes_.push_back(properties);
    Json& list = parent < 0 ? root_["scenes"][0]["nodes"] : nodes_[engine::at(parent)]["children"];
    list.push_back(node);
    return node;
}

void Document::add_camera(int node, double vertical_angle, double aspect, double near, double far) {
    Json& cameras = root_["cameras"];
    nodes_[engine::at(node)]["camera"] = cameras.size();
    cameras.push_back(
        {{"type", "perspective"},
         {"perspective", {{"aspectRatio", aspect}, {"yfov", vertical_angle}, {"znear", near}, {"zfar", far}}}});
}

void Document::add_sun(int node, const glm::vec3& colour, double lux) {
    const char* const extension = "KHR_lights_punctual";
    root_["extensionsUsed"] = Json::array({extension});
    Json& lights = root_["extensions"][extension]["lights"];
    nodes_[engine::at(node)]["extensions"][extension]["light"] = lights.size();
    lights.push_back({{"name", "sun"},
                      {"type", "directional"},
                      {"color", {shortest(colour.r), shortest(colour.g), shortest(colour.b)}},
                      {"intensity", lux}});
}

int Document::add_times(const Values& times) {
    const int accessor = add_accessor(time_view, times_.size(), floating, times.size(), "SCALAR");
    accessors_.back()["min"] = Json::array({shortest(times.front())});
    accessors_.back()["max"] = Json::array({shortest(times.back())});
    for (const float time : times) append(times_, time);
    return accessor;
}

void Document::add_channel(int node, Path path, int times, bool step, std::function<Values()> values) {
    const bool rotation = path == Path::rotation;
    if (is_constant(values(), rotation ? 4 : 3)) return;
    const auto count = accessors_[engine::at(times)]["count"].get<std::size_t>();
    Json sampler{{"input", times},
                 {"output", add_accessor(animation_view, animation_, floating, count, rotation ? "VEC4" : "VEC3")}};
    if (step) sampler["interpolation"] = "STEP";  // LINEAR is the default
    channels_.push_back({{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", name_of(path)}}}});
    samplers_.push_back(std::move(sampler));
    const std::size_t bytes = count * (rotation ? 4 : 3) * sizeof(float);
    animation_ += bytes;
    values_.emplace_back(bytes, std::move(values));
}

// The views in their order; those without data are absent, and accessors are renumbered.
void Document::finish_views() {
    std::array<int, 4> number{};
    std::size_t offset = 0;
    const auto add = [&](int view, std::size_t bytes, Json properties) {
        if (bytes == 0) return;
        number[engine::at(view)] = static_cast<int>(root_["bufferViews"].size());
        Json made{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes}};
        made.update(properties);
        root_["bufferViews"].push_back(std::move(made));
        offset += bytes;
    };
    add(vertex_view, vertices_.size(), {{"byteStride", 12}, {"target", array_buffer}});
    add(index_view, indices_.size(), {{"target", element_array_buffer}});
    add(time_view, times_.size(), Json::object());
    add(animation_view, animation_, Json::object());
    root_["buffers"] = Json::array({Json{{"byteLength", offset}}});
    for (Json& accessor : accessors_) {
        accessor["bufferView"] = number[accessor["bufferView"].get<std::size_t>()];
    }
}

void Document::write(OutputFile& file) {
    finish_views();
    root_["scene"] = 0;
    root_["nodes"] = nodes_;
    root_["accessors"] = accessors_;
    if (!channels_.empty())
        root_["animations"] = Json::array({Json{{"channels", channels_}, {"samplers", samplers_}}});
    std::string text = json_text(root_, -1);
    pad(text, ' ');

    const std::size_t binary = vertices_.size() + indices_.size() + times_.size() + animation_;
    const std::size_t all = 12 + 8 + text.size() + 8 + binary;
    if (all > std::numeric_limits<std::uint32_t>::max()) {
        throw OutputError("{}: {:.1f} GB are more than the 4.29 GB of a .glb file", file.name(),
                          1e-9 * static_cast<double>(all));
    }
    std::string start = "glTF";
    for (const std::size_t number : {std::size_t{2}, all, text.size()}) {
        append(start, static_cast<std::uint32_t>(number));
    }
    file.write(start + "JSON");
    file.write(text);
    std::string head;
    append(head, static_cast<std::uint32_t>(binary));
    file.write(head + std::string("BIN\0", 4));
    for (const std::string* part : {&vertices_, &indices_, &times_}) file.write(*part);
    for (const auto& [bytes, values_of] : values_) {
        const Values values = values_of();
        if (values.size() * sizeof(float) != bytes) throw std::logic_error("a channel changed its length");
        file.write({reinterpret_cast<const char*>(values.data()), bytes});
    }
}

}  // namespace pushfactor::demos::pictures::gltf
