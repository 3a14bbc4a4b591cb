// Geometry of plots: the Pareto front and the placement of labels.
#include "demos/reports/error/work_plot.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace pushfactor::demos::reports::error {

namespace {

constexpr double letter_height = 1.9;  // of a text line, in letter widths
constexpr double mark = 0.9;           // half the width of a point's mark

using Box = Eigen::AlignedBox2d;

Box around(const Place& centre, double half_width, double half_height) {
    const Place half(half_width, half_height);
    return {centre - half, centre + half};
}

// Sampled finely enough for the height of a label.
bool crosses(const Segment& line, const Box& box) {
    const int samples = static_cast<int>((line.to - line.from).norm() / 0.5) + 1;
    for (int k = 0; k <= samples; ++k) {
        const double share = static_cast<double>(k) / samples;
        if (box.intersects(around(line.from + share * (line.to - line.from), 0.1, 0.1))) return true;
    }
    return false;
}

}  // namespace

std::vector<std::optional<Place>> place_labels(const std::vector<Place>& points,
                                               const std::vector<std::string>& labels,
                                               const std::vector<Segment>& lines, const Place& corner) {
    const Box area(Place(0, 0), corner);
    std::vector<Box> taken;
    for (const Place& point : points) taken.push_back(around(point, mark, mark));
    std::vector<std::optional<Place>> places(points.size());
    const auto place = [&](std::size_t i, bool over_lines) {
        const double half = 0.5 * static_cast<double>(labels[i].size());
        const double aside = half + mark + 0.5;
        const double above = 0.5 * letter_height + mark + 0.1;
        for (const Place& offset :
             {Place(aside, 0), Place(-aside, 0), Place(0, above), Place(0, -above), Place(aside, above),
              Place(-aside, -above), Place(-aside, above), Place(aside, -above)}) {
            const Place centre = points[i] + offset;
            const Box box = around(centre, half, 0.5 * letter_height);
            const auto hit = [&box](const Box& other) { return box.intersects(other); };
            const auto cut = [&box](const Segment& line) { return crosses(line, box); };
            if (!area.contains(box) || std::ranges::any_of(taken, hit)) continue;
            if (!over_lines && std::ranges::any_of(lines, cut)) continue;
            places[i] = centre;
            taken.push_back(box);
            return;
        }
    };
    for (const bool over_lines : {false, true}) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!places[i]) place(i, over_lines);
        }
    }
    return places;
}

std::vector<std::size_t> pareto_front(std::span<const Trade> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {},
                      [points](std::size_t i) { return std::tuple(points[i].error, points[i].work, i); });
    // In order of rising error a point is on the front if it takes less work than all before it.
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        if (front.empty() || points[i].work < points[front.back()].work) front.push_back(i);
    }
    return front;
}

}  // namespace pushfactor::demos::reports::error
