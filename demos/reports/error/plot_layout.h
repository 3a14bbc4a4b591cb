// Geometry of plots: the Pareto front and the placement of labels.
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

// Indices of the points that no other point dominates (less error or work, and no more of the other), by rising
// error; of equal points the first.
std::vector<std::size_t> pareto_front(std::span<const Trade> points);

// A position in letter widths, y upwards.
struct Place {
    double x = 0.0, y = 0.0;
};

struct Segment {
    Place from, to;
};

// The centre of each label next to its point, so that none covers a point or another label, and if possible no
// line; none where there is no room. Labels stay inside the area from (0, 0) to `corner`.
std::vector<std::optional<Place>> place_labels(const std::vector<Place>& points,
                                               const std::vector<std::string>& labels,
                                               const std::vector<Segment>& lines, const Place& corner);

}  // namespace pushfactor::demos::reports::error
