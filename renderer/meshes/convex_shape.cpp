#include "renderer/meshes/convex_shape.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace pushfactor::renderer {
namespace {

// Vertices are numbered with 16 bits: one for each corner of each face.
constexpr std::size_t most_vertices = 65535;

using Edge = std::pair<int, int>;

int after(const std::vector<int>& face, std::size_t i) {
    return face[i + 1 < face.size() ? i + 1 : 0];
}

// A face with its sides moved inwards.
struct Inset {
    glm::vec3 normal;
    std::vector<glm::vec3> corners;
};

// Moves the sides of a face inwards by `bevel`, or by less where the face is small.
Inset inset(const ConvexShape& shape, const std::vector<int>& face, float bevel) {
    const auto at = [&](int corner) { return shape.corners[static_cast<std::size_t>(corner)]; };
    Inset result{glm::vec3(0.0f), {}};
    glm::vec3 middle(0.0f);
    for (std::size_t i = 0; i < face.size(); ++i) {
        result.normal += glm::cross(at(face[i]) - at(face[0]), at(after(face, i)) - at(face[0]));
        middle += at(face[i]) / static_cast<float>(face.size());
    }
    const float length = glm::length(result.normal);
    result.normal = length > 0.0f ? result.normal / length : glm::normalize(middle);

    std::vector<glm::vec3> inwards;
    float width = bevel;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const glm::vec3 in = glm::cross(result.normal, at(after(face, i)) - at(face[i]));
        const float size = glm::length(in);
        inwards.push_back(size > 0.0f ? in / size : glm::vec3(0.0f));
        width = std::min(width, 0.4f * glm::dot(inwards.back(), middle - at(face[i])));
    }
    width = std::max(width, 0.0f);
    for (std::size_t i = 0; i < face.size(); ++i) {
        const glm::vec3& next = inwards[i];
        const glm::vec3& last = inwards[i > 0 ? i - 1 : face.size() - 1];
        const float cosine = glm::dot(next, last);
        // Where both sides are `width` away; towards the middle where the corner is a needle.
        const glm::vec3 towards = cosine > -0.95f ? (next + last) / (1.0f + cosine) : glm::vec3(0.0f);
        const glm::vec3 moved =
            cosine > -0.95f ? at(face[i]) + width * towards : glm::mix(at(face[i]), middle, 0.1f);
        result.corners.push_back(moved);
    }
    return result;
}

class Builder {
  public:
    Builder(const glm::vec3& half, float bevel) : half_(half), bevel_(bevel) {}

    int add(const glm::vec3& point, const glm::vec3& normal) {
        mesh.vertices.push_back({(point - bevel_ * normal) / (half_ - bevel_), normal});
        return static_cast<int>(mesh.vertices.size()) - 1;
    }

    // A convex polygon, counter-clockwise seen from outside.
    void add_polygon(const std::vector<int>& polygon) {
        for (std::size_t i = 2; i < polygon.size(); ++i) {
            for (const int vertex : {polygon[0], polygon[i - 1], polygon[i]}) {
                mesh.indices.push_back(static_cast<std::uint16_t>(vertex));
            }
        }
    }

    Mesh mesh;

  private:
    glm::vec3 half_;
    float bevel_;
};

float least_width(const ConvexShape& shape) {
    float least = std::numeric_limits<float>::max();
    for (const std::vector<int>& face : shape.faces) {
        const glm::vec3 normal = inset(shape, face, 0.0f).normal;
        float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
        for (const glm::vec3& corner : shape.corners) {
            low = std::min(low, glm::dot(normal, corner));
            high = std::max(high, glm::dot(normal, corner));
        }
        least = std::min(least, high - low);
    }
    return least;
}

}  // namespace

bool before(const ConvexShape& a, const ConvexShape& b) {
    if (a.faces != b.faces) return a.faces < b.faces;
    if (a.corners.size() != b.corners.size()) return a.corners.size() < b.corners.size();
    const auto in_order = [](const glm::vec3& p, const glm::vec3& q) {
        return std::array{p.x, p.y, p.z} < std::array{q.x, q.y, q.z};
    };
    return std::lexicographical_compare(a.corners.begin(), a.corners.end(), b.corners.begin(), b.corners.end(),
                                        in_order);
}

std::string fault_of(const ConvexShape& shape) {
    for (const glm::vec3& corner : shape.corners) {
        if (!std::isfinite(corner.x) || !std::isfinite(corner.y) || !std::isfinite(corner.z)) {
            return ".corners are not finite";
        }
    }
    std::map<Edge, int> edges;
    std::size_t vertices = 0;
    for (const std::vector<int>& face : shape.faces) {
        if (face.size() < 3) return ".faces have less than three corners";
        vertices += face.size();
        for (std::size_t i = 0; i < face.size(); ++i) {
            if (face[i] < 0 || static_cast<std::size_t>(face[i]) >= shape.corners.size()) {
                return ".faces have corners that are not there";
            }
            ++edges[{face[i], after(face, i)}];
        }
    }
    if (edges.empty() || vertices > most_vertices) return ".faces are none or too many";
    for (const auto& [edge, count] : edges) {
        if (count != 1 || !edges.contains({edge.second, edge.first})) return ".faces do not close a surface";
    }
    return "";
}

glm::vec3 half_extents(const ConvexShape& shape) {
    glm::vec3 half(0.0f);
    for (const glm::vec3& corner : shape.corners) half = glm::max(half, glm::abs(corner));
    return half;
}

float roundness(const ConvexShape& shape) {
    const glm::vec3 half = half_extents(shape);
    return 0.6f * std::min({half.x, half.y, half.z});
}

Mesh convex_mesh(const ConvexShape& shape) {
    constexpr float bevel = 0.04f;  // of the least width, as for boxes
    const float width = bevel * least_width(shape);
    Builder builder(half_extents(shape), roundness(shape));
    // The vertex at the end `from` of each edge, in the face on its left.
    std::map<Edge, int> vertex_at;
    std::map<Edge, int> before_edge;  // the corner before `from` in that face
    for (const std::vector<int>& face : shape.faces) {
        const Inset inner = inset(shape, face, width);
        std::vector<int> polygon;
        for (std::size_t i = 0; i < face.size(); ++i) {
            polygon.push_back(builder.add(inner.corners[i], inner.normal));
            vertex_at[{face[i], after(face, i)}] = polygon.back();
            before_edge[{face[i], after(face, i)}] = face[i > 0 ? i - 1 : face.size() - 1];
        }
        builder.add_polygon(polygon);
    }
    std::map<Edge, int> end_of;  // the vertex at the other end in the same face
    for (const auto& [next, previous] : before_edge) end_of[{previous, next.first}] = vertex_at.at(next);
    for (const auto& [edge, vertex] : vertex_at) {
        const Edge back{edge.second, edge.first};
        if (edge < back) {
            builder.add_polygon({vertex, end_of.at(back), vertex_at.at(back), end_of.at(edge)});
        }
    }
    // Around each corner, face by face: the edge before it in a face, turned around, begins the next face.
    std::map<int, bool> done;
    for (const auto& [edge, vertex] : vertex_at) {
        if (done[edge.first]) continue;
        done[edge.first] = true;
        std::vector<int> polygon;
        Edge around = edge;
        do {
            polygon.push_back(vertex_at.at(around));
            around = {edge.first, before_edge.at(around)};
        } while (around != edge && polygon.size() <= shape.corners.size());
        builder.add_polygon(polygon);
    }
    return std::move(builder.mesh);
}

}  // namespace pushfactor::renderer
