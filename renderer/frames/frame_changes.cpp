#include "renderer/frames/frame_changes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

namespace pushfactor::renderer {
namespace {

// Strict order of instances in which only identical ones are equivalent.
bool before_in_order(const Instance& a, const Instance& b) {
    static_assert(sizeof(Instance) == 15 * sizeof(float), "bytes between the members would be compared too");
    if (a.number != b.number) return a.number < b.number;
    return std::memcmp(&a, &b, sizeof(Instance)) < 0;  // NOLINT(bugprone-suspicious-memory-comparison)
}

using Instances = std::vector<Instance>;

// Result of comparing two lists: elements of only one, and elements of both.
struct Comparison {
    Instances differing;
    Instances equal;
};

Comparison compare(Instances a, Instances b) {
    std::ranges::sort(a, before_in_order);
    std::ranges::sort(b, before_in_order);
    Comparison found;
    std::ranges::set_symmetric_difference(a, b, std::back_inserter(found.differing), before_in_order);
    std::ranges::set_intersection(a, b, std::back_inserter(found.equal), before_in_order);
    return found;
}

struct BodiesComparison {
    Bodies differing;
    Bodies equal;
};

BodiesComparison compare(const Bodies& a, const Bodies& b) {
    BodiesComparison found;
    for (Instances Bodies::*const kind : {&Bodies::boxes, &Bodies::spheres, &Bodies::polyhedra, &Bodies::bars}) {
        Comparison of_kind = compare(a.*kind, b.*kind);
        found.differing.*kind = std::move(of_kind.differing);
        found.equal.*kind = std::move(of_kind.equal);
    }
    return found;
}

bool same_shapes(const Bodies& a, const Bodies& b) {
    return std::ranges::equal(a.shapes, b.shapes, [](const auto& p, const auto& q) { return p == q || *p == *q; });
}

// Distance along the light between the first and the last shadow caster or receiver, m.
float depth_of(const Bodies& some, const Bodies& others, std::span<const Panel> panels,
               const glm::vec3& towards_sun) {
    float low = std::numeric_limits<float>::max();
    float high = std::numeric_limits<float>::lowest();
    const auto add = [&](const glm::vec3& point, float radius) {
        low = std::min(low, glm::dot(point, towards_sun) - radius);
        high = std::max(high, glm::dot(point, towards_sun) + radius);
    };
    for (const Bodies* bodies : {&some, &others}) {
        for (const Instance& body : bodies->all()) add(body.position, bounding_radius(body));
    }
    for (const Panel& panel : panels) {
        for (const glm::vec3& corner : panel.corners) add(corner, 0.0f);
    }
    return high - low;
}

// Tiles in which the shadow map is or may be looked up.
Tiles where_shadows_matter(const FrameView& view, const FrameContents& contents) {
    const Instances bodies = contents.bodies.all();
    Tiles tiles = occupied_tiles(view, bodies, contents.panels);
    if (contents.ground) tiles.add(shadowed_tiles(view, bodies, *contents.ground));
    return tiles;
}

// Tiles in one rendering that change because of differing bodies.
Tiles changed_tiles(const FrameView& view, const BodiesComparison& bodies, const FrameContents& now) {
    const Instances differing = bodies.differing.all();
    Tiles tiles = occupied_tiles(view, differing, {});
    if (now.ground) {
        tiles.add(shadowed_tiles(view, differing, *now.ground));
        tiles.add(touched_tiles(view, bodies.differing.thick(), *now.ground));
    }
    const Instances still = bodies.equal.all();
    if (!still.empty() || !now.panels.empty()) {
        const float depth = depth_of(bodies.differing, bodies.equal, now.panels, view.towards_sun);
        Tiles swept = swept_tiles(view, differing, depth);
        swept.keep_only(occupied_tiles(view, still, now.panels));
        tiles.add(swept);
    }
    return tiles;
}

}  // namespace

Tiles changed_tiles(const FrameContents& before, const FrameContents& now) {
    Tiles tiles(now.views.front().width, now.views.front().height);
    if (before.camera != now.camera || before.background != now.background || before.ground != now.ground ||
        before.panels != now.panels || !same_shapes(before.bodies, now.bodies)) {
        tiles.add_all();
        return tiles;
    }
    const BodiesComparison bodies = compare(before.bodies, now.bodies);
    // A body darkens all that is near it.
    if (!now.skies.empty() && !bodies.differing.all().empty()) {
        tiles.add_all();
        return tiles;
    }
    const bool other_maps = before.suns != now.suns;
    const bool none_differs = bodies.differing.all().empty();
    for (std::size_t i = 0; i < now.views.size(); ++i) {
        if (!none_differs) tiles.add(changed_tiles(now.views[i], bodies, now));
        // Another map is rounded differently, even for equal shadows.
        if (other_maps) {
            tiles.add(where_shadows_matter(before.views[i], before));
            tiles.add(where_shadows_matter(now.views[i], now));
        }
    }
    return tiles;
}

}  // namespace pushfactor::renderer
