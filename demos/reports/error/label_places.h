// Where the labels of points go, so that none covers a point or another label, and where there is room no line.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

// In widths of a letter, y upwards.
struct Place {
    double x = 0.0, y = 0.0;
};

struct Segment {
    Place from, to;
};

// The centre of each label beside its point, in the order of the points; nothing where there is no room. Labels
// keep inside the area from (0, 0) to `corner`.
std::vector<std::optional<Place>> place_labels(const std::vector<Place>& points,
                                               const std::vector<std::string>& labels,
                                               const std::vector<Segment>& lines, const Place& corner);

}  // namespace pushfactor::demos::reports::error
