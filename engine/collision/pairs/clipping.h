// How two polyhedra touch along an axis, paper section 4: "clipping the most penetrating face of the first
// polyhedron to the volume below the corresponding anti-parallel face on the second".
//
// Both faces are seen along the axis, whether it is normal to one of them or to two edges, of which the crossing is
// then the lowest corner; so what touches does not change with the axis. (One point for two edges lets a rod that
// lies across another roll to and fro between them.)
#pragma once

#include "engine/base/math.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace pushfactor::engine::collision {

// A clipped face. A Corner has `edge`, the label of the edge to the next corner, and between().
template <typename Corner, std::size_t most>
struct Polygon {
    // The first `count` are valid. A face clipped by the sides of another has at most as many corners as both
    // together; rounding could add a sliver corner that coincides with the one before it.
    std::array<Corner, most> corners;
    int count = 0;

    Polygon() {}  // NOLINT(modernize-use-equals-default): the corners stay uninitialised
    void add(const Corner& corner) {
        if (static_cast<std::size_t>(count) < most) corners[static_cast<std::size_t>(count++)] = corner;
    }
    const Corner& at(int i) const {
        return corners[static_cast<std::size_t>(i < count ? i : i - count)];
    }  // i < 2 count
};

// The name of a corner between two edges, whichever comes first when one looks from the other side.
inline std::uint32_t corner_of(std::uint32_t before, std::uint32_t after) {
    return std::min(before, after) << 11 | std::max(before, after);
}

// Sutherland-Hodgman: keeps the part that is not beyond a side, whose edge gets the label `side`. `beyond(corner)`
// is the distance from it [m], positive outside. Returns false if nothing is cut and `result` is not written.
template <typename Corner, std::size_t most, typename Beyond>
bool clip(const Polygon<Corner, most>& polygon, const Beyond& beyond, std::uint32_t side,
          Polygon<Corner, most>& result) {
    bool cuts = false;
    for (int i = 0; i < polygon.count && !cuts; ++i) cuts = beyond(polygon.at(i)) > 0.0;
    if (!cuts) return false;
    result.count = 0;
    double out_to = beyond(polygon.at(0));
    for (int i = 0; i < polygon.count; ++i) {
        const Corner& from = polygon.at(i);
        const Corner& to = polygon.at(i + 1);
        const double out_from = out_to;
        out_to = beyond(to);
        if (out_from <= 0.0) result.add(from);
        if ((out_from <= 0.0) == (out_to <= 0.0)) continue;
        Corner cut = between(from, to, out_from / (out_from - out_to));
        cut.edge = out_from <= 0.0 ? side : from.edge;  // if it leaves here, the next edge runs along this side
        result.add(cut);
    }
    return true;
}

}  // namespace pushfactor::engine::collision
