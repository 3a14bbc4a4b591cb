// Geometry of plots: which points are on the Pareto front, and where labels go.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

struct Trade {
    double error = 0.0;
    double work = 0.0;
};

// Indices of the points that no other point beats: no other has less of one without more of the other. In the order
// of rising error, of equal points the first.
std::vector<std::size_t> pareto_front(std::span<const Trade> points);

// In widths of a letter, y upwards.
struct Place {
    double x = 0.0, y = 0.0;
};

struct Segment {
    Place from, to;
};

// The centre of each label next to its point, in the order of the points, so that none covers a point or another
// label, and where there is room no line; nothing where there is no room. Labels keep inside the area from (0, 0)
// to `corner`.
std::vector<std::optional<Place>> place_labels(const std::vector<Place>& points,
                                               const std::vector<std::string>& labels,
                                               const std::vector<Segment>& lines, const Place& corner);

}  // namespace pushfactor::demos::reports::error
